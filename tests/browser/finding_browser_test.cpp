#include "coupling/finding/finding_page.hpp"
#include "tests/browser/chromium.hpp"
#include "tests/support/sample_finding.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace {

/// What the page shows, noted on <html>.
std::string const look = R"(
const note = (name, value) => { document.documentElement.dataset[name] = String(value); };
note('fetched', performance.getEntriesByType('resource').filter(e => !e.name.startsWith('data:')).length);
note('tooWide', document.documentElement.scrollWidth > window.innerWidth);
note('badText', [...document.querySelectorAll('svg text, td, li, p')].filter(t => /NaN|undefined|null|Infinity/.test(t.textContent)).length);
note('nameless', document.querySelectorAll('svg[role=img]:not([aria-label])').length);
note('runs', document.querySelectorAll('#runs h3').length);
note('heldOut', [...document.querySelectorAll('#runs h3 small')].filter(t => /held out/.test(t.textContent)).length);
const range = id => [...document.querySelectorAll(`#${id} svg text[text-anchor=end]`)].map(t => parseFloat(t.textContent.replace('\u2212', '-')));
note('restHigh', Math.max(...range('run-0-0-rest')));
)";

struct FindingInBrowser : ::testing::Test {
  support::ScratchFolder folder;

  browser::Page shown(coupling::finding::Finding const& finding) {
    support::put_bytes(folder / "report.html", coupling::finding::finding_page(finding));
    return browser::open(folder / "report.html", look);
  }

  static void expect_clean(browser::Page const& page) {
    EXPECT_EQ(page.console, "");
    EXPECT_EQ(page.note("ready"), "1");
    EXPECT_EQ(page.note("fetched"), "0");
    EXPECT_EQ(page.note("too-wide"), "false");
    EXPECT_EQ(page.note("bad-text"), "0");
    EXPECT_EQ(page.note("nameless"), "0");
  }
};

TEST_F(FindingInBrowser, DrawsEveryRunAndWhatIsLeft) {
  auto const page = shown(sample::named());
  expect_clean(page);
  EXPECT_EQ(page.note("runs"), "3");
  EXPECT_EQ(page.note("held-out"), "1");
  EXPECT_EQ(page.note("charts"), "12"); // 3 runs, 2 channels, 2 charts
  // Measured and two simulated; zero and two differences.
  EXPECT_EQ(page.note("points"), std::to_string(6 * 90 * (3 + 3)));
  // The softer frame costs kilonewtons: the difference is in their unit.
  EXPECT_GT(page.number("rest-high"), 1.0);
  EXPECT_LT(page.number("rest-high"), 20.0);
}

TEST_F(FindingInBrowser, DrawsWithoutACauseAndWithoutPlaces) {
  auto finding = sample::consistent();
  for (auto& curve : finding.curves) {
    curve.gap.clear();
    curve.measured[5] = coupling::finding::not_known;
  }
  finding.curves[2].time.clear();
  auto const page = shown(finding);
  expect_clean(page);
  EXPECT_EQ(page.note("charts"), "12");
  EXPECT_EQ(page.note("points"), std::to_string(6 * (89 + 90 + 90 + 89)));
  finding.curves.clear();
  EXPECT_NE(shown(finding).dom.find("There are no curves to draw"), std::string::npos);
}

TEST_F(FindingInBrowser, RunsNothingThatANameSmugglesIn) {
  auto finding = sample::undecided();
  std::string const hostile =
      "</script><img src=x onerror=\"document.documentElement.dataset.hacked='1'\">";
  finding.provenance.data_folder = finding.group[0] = hostile;
  for (auto& curve : finding.curves)
    curve.run = curve.channel = hostile;
  auto const page = shown(finding);
  expect_clean(page);
  EXPECT_EQ(page.note("hacked"), "(absent)");
}

} // namespace
