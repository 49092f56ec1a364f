#include "coupling/case_schema.hpp"
#include "coupling/case_text.hpp"
#include "coupling/prm_lines.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

namespace coupling {

namespace {

class CaseVocabulary : public PrmVocabulary {
public:
  std::string_view noun() const override { return "a case"; }

  void check_section(std::string const& where, std::string_view path) const override {
    VALIDATE(is_section(path), fmt::format("{}: subsection {}: is no section of a case.{}", where,
                                           quote(path), suggest_section(path)));
  }

  void check_entry(std::string const& where, std::string_view path,
                   std::string_view text) const override {
    check_assignment(where, path, text);
  }
};

} // namespace

std::vector<Assignment> scan_prm(std::string_view text, std::string const& name) {
  return scan_prm_lines(text, name, CaseVocabulary());
}

} // namespace coupling
