#include "coupling/elastic/session.hpp"

#include "continuum/session.hpp"

namespace coupling {

void ensure_session() {
  if (!continuum::Session::is_active())
    static continuum::Session const session;
}

} // namespace coupling
