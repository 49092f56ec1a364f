#include "coupling/compare/compare.hpp"
#include "tests/browser/chromium.hpp"
#include "tests/support/sample_report.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace {

TEST(ComparisonInBrowser, OverlaysTheCurvesOfAllSources) {
  support::ScratchFolder folder;
  coupling::PressRecord observed({{"punch_gap", "m"}, {"upper_punch_force", "N"}});
  for (int k = 0; k < 50; ++k)
    observed.add_row("", {13e-3 - 1e-4 * k, 30.0 * k});
  auto const c =
      coupling::compare({{.label = "run", .record = sample::record(), .values = {}},
                         {.label = "</script><b>observed", .record = observed, .values = {}}});
  coupling::write_comparison(folder / "comparison.html", c);
  auto const page = browser::open(folder / "comparison.html",
                                  "document.documentElement.dataset.keys = "
                                  "document.querySelectorAll('#force-gap .legend button').length;"
                                  "document.documentElement.dataset.fetched = "
                                  "performance.getEntriesByType('resource').length;");
  EXPECT_EQ(page.console, "");
  EXPECT_EQ(page.note("ready"), "1");
  EXPECT_EQ(page.note("charts"), "4");
  // run: force over gap, force, height and overlap over time, 400 rows each; observed: force over
  // gap, 50 rows
  EXPECT_EQ(page.note("points"), "1650");
  EXPECT_EQ(page.note("keys"), "2");
  EXPECT_EQ(page.note("fetched"), "0");
  EXPECT_EQ(page.dom.find("<b>observed"), std::string::npos);
}

} // namespace
