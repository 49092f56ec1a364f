#include "coupling/study/study_page.hpp"
#include "tests/browser/chromium.hpp"
#include "tests/support/sample_report.hpp"
#include "tests/support/scratch_folder.hpp"

#include "coupling/record/curves.hpp"

#include <gtest/gtest.h>

namespace {

using namespace coupling::study;

/// What the page shows, noted on <html>.
std::string const look = R"(
const note = (name, value) => { document.documentElement.dataset[name] = String(value); };
note('fetched', performance.getEntriesByType('resource').filter(e => !e.name.startsWith('data:')).length);
note('tooWide', document.documentElement.scrollWidth > window.innerWidth);
note('badText', [...document.querySelectorAll('svg text, td, li')].filter(t => /NaN|undefined|null|Infinity/.test(t.textContent)).length);
note('nameless', document.querySelectorAll('svg[role=img]:not([aria-label])').length);
note('outside', [...document.querySelectorAll('.plot svg text')].filter(t => {
  const a = t.getBoundingClientRect(), b = t.closest('figure').getBoundingClientRect();
  return a.width > 0 && (a.left < b.left - 2 || a.right > b.right + 2); }).length);
note('lines', document.querySelectorAll('#force-time .plot svg g[clip-path] path').length);
note('keys', document.querySelectorAll('#force-time .legend button').length);
)";

struct StudyInBrowser : ::testing::Test {
  support::ScratchFolder folder;

  browser::Page shown(ResultsTable const& table, StudyPlan const& plan) {
    auto const analysis = analyse_if_complete(table);
    write_study_page({table, plan, analysis}, folder / "report.html");
    return browser::open(folder / "report.html", look);
  }

  static StudyPlan plan_of(std::string const& name) {
    return plan_study(read_study(PRESSCHECK_SOURCE_DIR "/cases/seed-study/" + name));
  }

  static void expect_clean(browser::Page const& page) {
    EXPECT_EQ(page.console, "");
    EXPECT_EQ(page.note("ready"), "1");
    EXPECT_EQ(page.note("fetched"), "0");
    EXPECT_EQ(page.note("too-wide"), "false");
    EXPECT_EQ(page.note("bad-text"), "0");
    EXPECT_EQ(page.note("nameless"), "0");
    EXPECT_EQ(page.note("outside"), "0");
  }
};

TEST_F(StudyInBrowser, DrawsTheSeedsCalibration) {
  auto const plan = plan_of("calibration-liggghts.prm");
  auto const page = shown(results_as_data(plan), plan);
  expect_clean(page);
  // Of each of three responses: a surface, observed against predicted, the effects.
  EXPECT_EQ(page.note("charts"), "9");
  EXPECT_EQ(page.note("points"), "33"); // 9 runs and the 2 ends of the diagonal, three times
  EXPECT_NE(page.dom.find("There are no curves to draw"), std::string::npos);
}

TEST_F(StudyInBrowser, DrawsTheSeedsFinerAlumina) {
  auto const plan = plan_of("fineness-edem.prm");
  auto const page = shown(results_as_data(plan), plan);
  expect_clean(page);
  EXPECT_EQ(page.note("charts"), "4"); // the line, observed against predicted, effects, figure 6a
  // The line twice 61 and 4 runs; 4 + 2; five forms with 61 each and 4 runs.
  EXPECT_EQ(page.note("points"), std::to_string(2 * 61 + 4 + 4 + 2 + 5 * 61 + 4));
}

TEST_F(StudyInBrowser, DrawsThreeFactorsTwoByTwo) {
  auto const plan = plan_of("screening-liggghts.prm");
  auto const page = shown(results_as_data(plan), plan);
  expect_clean(page);
  EXPECT_EQ(page.note("charts"), "15"); // three surfaces and two more of each response
}

TEST_F(StudyInBrowser, DrawsTheRunsOfASetUpAsOneLine) {
  auto const plan = plan_of("screening-edem.prm");
  auto table = results_as_data(plan);
  coupling::write_curves(folder / "curves.csv", sample::record());
  for (std::size_t const k : {0U, 1U, 2U})
    table.rows[k].folder = folder.path();
  table.rows[1].run.setup = table.rows[0].run.setup; // a second packing
  table.study.title =
      "</script><img src=x onerror=\"document.documentElement.dataset.hacked='1'\">";
  auto const page = shown(table, plan);
  expect_clean(page);
  EXPECT_EQ(page.note("hacked"), "(absent)");
  EXPECT_EQ(page.note("charts"), "18"); // and figures 4 a, b, c
  EXPECT_EQ(page.note("keys"), "2");
  EXPECT_EQ(page.note("lines"), "2");
}

} // namespace
