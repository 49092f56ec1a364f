#include "coupling/record/atomic_file.hpp"
#include "coupling/reduced/grain_library.hpp"

#include <fmt/format.h>

#include <exception>

/// grain_effects STUDY FILE: what the runs of a study's folder do to a bed's numbers, as a table.
int main(int n, char** words) {
  if (n != 3) {
    fmt::print(stderr, "grain_effects: STUDY FILE: a study's folder and the table to write\n");
    return 2;
  }
  try {
    auto const library = coupling::reduced::read_library(words[1]);
    coupling::write_file(words[2],
                         coupling::reduced::library_json(
                             library, "presscheck study cases/seed-library/library.prm -o STUDY; "
                                      "grain_effects STUDY cases/seed-library/grain_effects.json"));
  } catch (std::exception const& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 2;
  }
}
