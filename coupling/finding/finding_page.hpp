#pragma once

#include "coupling/finding/finding.hpp"

namespace coupling::finding {

/// report.html of a diagnosis: one file that needs a browser and nothing else. Tables read without
/// JavaScript; the curves need it. The same finding gives the same bytes.
std::string finding_page(Finding const& finding);

} // namespace coupling::finding
