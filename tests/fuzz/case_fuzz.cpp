// clang-format off
// fuzz-build: coupling/case_breakage.cpp coupling/case_build.cpp coupling/case_checks.cpp coupling/case_contacts.cpp
// fuzz-build: coupling/case_file.cpp coupling/case_fill.cpp coupling/case_print.cpp
// fuzz-build: coupling/case_reader.cpp
// fuzz-build: coupling/case_scan_*.cpp coupling/case_schema*.cpp
// fuzz-build: coupling/case_stages.cpp coupling/case_text.cpp
// fuzz-build: coupling/case_tool_shapes.cpp
// fuzz-build: coupling/case_value.cpp coupling/nearest_name.cpp coupling/press_stages.cpp
// fuzz-build: coupling/prm_lines.cpp coupling/quantity.cpp coupling/quote.cpp coupling/units.cpp
// fuzz-build: dem/material.cpp dem/spheres.cpp
// fuzz-build: -isystem /usr/lib/x86_64-linux-gnu/openmpi/include -isystem /usr/include/trilinos
// fuzz-build: -isystem /usr/include/suitesparse
// fuzz-build: -Wl,--as-needed -Wl,--copy-dt-needed-entries -ldeal.ii -lfmt
// clang-format on
#include "coupling/case_file.hpp"
#include "dem/expect.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

/// Any text is either refused with InvalidInput, in one line, or is a case whose resolved text is
/// that case again. A leading J makes it a .json case, anything else a .prm; what follows the first
/// byte 1 is an override.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  if (size == 0)
    return 0;
  std::string text(reinterpret_cast<char const*>(data) + 1, size - 1);
  std::vector<std::string> overrides;
  if (auto const mark = text.find('\1'); mark != std::string::npos) {
    overrides.push_back(text.substr(mark + 1));
    text.resize(mark);
  }
  try {
    auto const accepted =
        coupling::parse_case(text, data[0] == 'J' ? "f.json" : "f.prm", overrides);
    auto const again = coupling::parse_case(accepted.resolved_text, "resolved.prm");
    if (again.resolved_text != accepted.resolved_text)
      std::abort();
  } catch (dem::InvalidInput const& refusal) {
    std::string_view const message = refusal.what();
    if (message.empty() || message.find('\n') != std::string_view::npos)
      std::abort();
  }
  return 0;
}
