// clang-format off
// fuzz-build: coupling/record/atomic_file.cpp coupling/record/csv.cpp coupling/record/curves.cpp
// fuzz-build: coupling/record/press_record.cpp
// fuzz-build: -lfmt
// clang-format on
#include "coupling/record/curves.hpp"
#include "dem/expect.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

/// Any text is either refused with InvalidInput or is a record whose rows and columns agree.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  try {
    auto const record =
        coupling::parse_curves({reinterpret_cast<char const*>(data), size}, "fuzz.csv");
    if (record.size() == 0 || record.stages().size() != record.size())
      std::abort();
    for (auto const& row : record.rows())
      if (row.size() != record.columns().size())
        std::abort();
  } catch (dem::InvalidInput const&) {
  }
  return 0;
}
