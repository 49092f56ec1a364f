#pragma once

#include "dem/contact/contact_choice.hpp"

#include <memory>

namespace dem {

class ContactEngine {
public:
  ContactEngine();
  explicit ContactEngine(ContactChoice const& choice);

  ContactChoice const& choice() const { return choice_; }

private:
  ContactChoice choice_;
};

}  // namespace dem
