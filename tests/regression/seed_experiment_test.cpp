#include "tests/regression/program.hpp"
#include "tests/support/scratch_folder.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>

/// The four numbers of the seed's press experiment (cases/seed-experiment): gap and compact height
/// contradict each other by 0.6 to 1.3 mm, and a frame that gives cannot be told from a zero that
/// is off (bar B18 of the diagnosis note).
TEST(SeedExperiment, MissesSomeOfItsApproach) {
  support::ScratchFolder scratch;
  auto const folder = scratch / "diagnosis";
  auto const outcome =
      program::run({"diagnose", PRESSCHECK_SOURCE_DIR "/cases/seed-experiment/case.prm",
                    PRESSCHECK_SOURCE_DIR "/cases/seed-experiment", "-o", folder.string()});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  auto const found = nlohmann::json::parse(support::bytes_of(folder / "diagnosis.json"));
  EXPECT_EQ(found["verdict"], "undecided");
  auto const size_of = [&](std::string const& name) {
    auto const is_it = [&](auto const& cause) { return cause["name"] == name; };
    auto const cause = std::ranges::find_if(found["causes"], is_it);
    return cause == found["causes"].end()
               ? 0.0
               : (*cause)["parameters"].front()["value"].template get<double>();
  };
  for (auto const* const name : {"frame_compliance", "gap_offset"})
    EXPECT_EQ(std::ranges::count(found["group"], name), 1) << name;
  // [m]; the frame gives its compliance times 25 095 N, and 0.15 of 3 kN more for its seats.
  for (double const missing :
       {size_of("gap_offset"), size_of("frame_compliance") * (25095.0 + 0.15 * 3000.0)}) {
    EXPECT_GT(missing, 0.6e-3);
    EXPECT_LT(missing, 1.3e-3);
  }
  ASSERT_FALSE(found["next_measurement"].empty());
}
