#include "coupling/finding/finding.hpp"

#include <algorithm>
#include <iterator>

namespace coupling::finding {

std::vector<FoundCause> named_causes(Finding const& finding) {
  std::vector<FoundCause> named;
  if (finding.verdict == "named")
    std::ranges::copy_if(finding.causes, std::back_inserter(named), &FoundCause::is_named);
  return named;
}

FoundCause const* find_cause(Finding const& finding, std::string_view name) {
  auto const found = std::ranges::find(finding.causes, name, &FoundCause::name);
  return found == finding.causes.end() ? nullptr : &*found;
}

} // namespace coupling::finding
