// What a diagnosis' page holds, for each verdict and for hostile names.
#include "coupling/finding/cause_words.hpp"
#include "coupling/finding/finding_page.hpp"
#include "coupling/finding/page_parts.hpp"
#include "tests/support/sample_finding.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace coupling::finding {
namespace {

bool has(std::string const& page, std::string const& part) {
  return page.find(part) != std::string::npos;
}

TEST(FindingPage, HasEverySectionOfANamedCause) {
  auto finding = sample::named();
  finding.extension = {{"Press frame/Stiffness", "0 N/m", "55555556 N/m", "frame_compliance"}};
  auto const page = finding_page(finding);
  for (auto const* id : {"answer", "misfit", "curves", "causes", "gain", "extension", "detectable",
                         "assumed", "reading", "provenance"})
    EXPECT_TRUE(has(page, std::string("<section class=\"card\" id=\"") + id + "\">")) << id;
  EXPECT_FALSE(has(page, "id=\"unknown\""));
  EXPECT_FALSE(has(page, "id=\"next\""));
  EXPECT_TRUE(has(page, "<strong>The press frame gives way (18 µm/kN). Probability: 97 %. With "
                        "that the simulation agrees with the measurement.</strong>"));
  EXPECT_FALSE(has(page, ">nan") || has(page, " nan") || has(page, "not reached"));
  EXPECT_FALSE(has(page, "src=") || has(page, "href=")) << "nothing from outside";
}

TEST(FindingPage, SaysWhatAnIncompleteNameLeaves) {
  auto finding = sample::named();
  finding.is_incomplete = true;
  EXPECT_TRUE(has(verdict_part(finding), "As it is known, it does not explain all of it."));
}

TEST(FindingPage, ForetellsWhatTheNextMeasurementReads) {
  auto const page = finding_page(sample::undecided());
  EXPECT_TRUE(has(page, "cannot tell which: the press frame gives way or the load cell lags "
                        "behind."));
  EXPECT_TRUE(has(page, "1. hold at 25 kN for 60 s, fall of the upper force"));
  EXPECT_TRUE(has(page, "tells them apart; now 1.4 standard uncertainties apart, then 9.8"));
  EXPECT_TRUE(has(page, "<th scope=\"col\" class=\"number\">if the load cell lags behind</th>"));
  EXPECT_TRUE(has(page, "force on the upper punch while holding, at a gap of 8.000 mm</th><td "
                        "class=\"number\">12.00 N ± 9.0 N</td><td class=\"number\">310.0 N ± "
                        "28 N</td>"));
  EXPECT_TRUE(has(page, "gap between the punches at the largest force</th><td class=\"number\">"
                        "450.0 µm ± 8.0 µm</td>"));
  EXPECT_TRUE(has(page, "Compliance of the press frame does the same to these data as lag of the "
                        "load cell."));
}

TEST(FindingPage, DescribesWhatNoCauseExplains) {
  auto const page = finding_page(sample::unknown());
  EXPECT_TRUE(has(page, "<strong>force on the upper punch</strong> while <strong>pressing</strong>"
                        ", most (58 %) in run2.csv"));
  EXPECT_TRUE(has(page, "bump in force"));
  EXPECT_TRUE(has(page, "grains break (cosine +0.41"));
}

TEST(FindingPage, SaysThatNothingIsWrongAndWhatStaysHidden) {
  auto const page = finding_page(sample::consistent());
  EXPECT_TRUE(has(page, "class=\"verdict pass\""));
  EXPECT_TRUE(has(page, "Nothing wrong was found"));
  EXPECT_TRUE(has(page, "cannot be seen in these data"));
  EXPECT_TRUE(has(page, "<td class=\"number\">0.36 µm/kN</td>"));
  EXPECT_TRUE(has(finding_page({.verdict = "consistent"}), "Nothing wrong was found"));
}

TEST(FindingPage, PutsEveryCellInItsPlace) {
  auto const map = misfit_part(sample::named());
  EXPECT_TRUE(has(map, "<th scope=\"col\">pressing</th><th scope=\"col\">opening</th><th "
                       "scope=\"col\">after the press</th>"));
  EXPECT_TRUE(
      has(map, "<td class=\"much\"><strong>-21.3</strong>measured falls against the model"));
  EXPECT_TRUE(has(map, "<td><strong>+1.1</strong>agrees"));
  EXPECT_TRUE(has(map, "<td class=\"nothing\"></td>"));
}

TEST(FindingPage, ShowsTheGainBesideThePlacebo) {
  auto const html = gain_part(sample::named());
  // 912 N to 12 %; the wrong cause 71 %.
  EXPECT_TRUE(has(html, "<td class=\"number\">912.0 N</td><td class=\"number\">109.4 N</td><td "
                        "class=\"number\">12 %</td><td class=\"number\">8 % to 17 %</td><td "
                        "class=\"number\">95 %</td><td class=\"number\">71 %</td>"))
      << html;
  EXPECT_TRUE(has(html, "rises by 341 (by chance it would scatter by 31)"));
  auto finding = sample::named();
  finding.gain.reset();
  EXPECT_TRUE(has(gain_part(finding), "Not measured: no run was held out"));
}

TEST(FindingPage, EscapesWhatPeopleWrote) {
  std::string const hostile = "</script><script>alert(1)</script>";
  auto finding = sample::undecided();
  finding.provenance.case_file = finding.provenance.data_folder = hostile;
  finding.provenance.simulation = finding.seeds[0].purpose = hostile;
  finding.unknown = sample::unknown().unknown;
  finding.unknown->run = finding.unknown->forms[0].input = finding.unknown->nearest = hostile;
  finding.sentences.push_back(hostile);
  finding.decisions.push_back(hostile);
  finding.not_claimed.push_back(hostile);
  finding.not_modelled.push_back(hostile);
  finding.group.push_back(hostile);
  finding.extension.push_back({hostile, hostile, hostile, hostile});
  finding.measurements[0].name = finding.measurements[0].readings[0].channel = hostile;
  finding.measurements[0].readings[0].unit = finding.measurements[0].readings[0].phase = hostile;
  finding.gain = sample::gain(hostile, 0.5, 3.0);
  for (auto& cause : finding.causes)
    cause.name = cause.plausibility = hostile;
  for (auto& curve : finding.curves)
    curve.run = curve.channel = curve.unit = hostile;
  finding.misfit[0].channel = finding.misfit[0].shape = finding.misfit[1].phase = hostile;
  finding.levels[0].run = finding.tolerances[0].source = finding.detectable[0].cause = hostile;
  finding.calibrated[0].name = hostile;
  auto const page = finding_page(finding);
  EXPECT_FALSE(has(page, "<script>alert"));
  EXPECT_FALSE(has(page, "alert(1)</script>"));
}

TEST(CauseWords, ShowsSizesInTheUnitsOfAPress) {
  EXPECT_EQ(size_in_words("frame_compliance", 1.82e-8, "m/N"), "18.2 µm/kN");
  EXPECT_EQ(size_in_words("thermal_drift", 1.0e-7, "m/s"), "6 µm/min");
  EXPECT_EQ(size_in_words("die_compliance", 5e-13, "m/Pa"), "0.5 µm/MPa");
  EXPECT_EQ(size_in_words("gap_offset", -1.1e-4, "m"), "-110 µm");
  EXPECT_EQ(size_in_words("mass_error", 0.0152, "1"), "1.52 %");
  EXPECT_EQ(size_in_words("wall_friction", 0.06, "1"), "0.06");
  EXPECT_EQ(size_in_words("force_offset", 120.0, "N"), "120.0 N");
  EXPECT_EQ(size_in_words("force_lag", not_known, "s"), "not known");
}

/// For looking at it: PRESSCHECK_PAGES=FOLDER writes one page a verdict.
TEST(FindingPage, CanBeLookedAt) {
  support::ScratchFolder const scratch;
  char const* const named_folder = std::getenv("PRESSCHECK_PAGES");
  auto const folder = named_folder ? std::filesystem::path(named_folder) : scratch.path();
  auto named = sample::named();
  named.extension = {{"Press frame/Stiffness", "0 N/m", "55555556 N/m",
                      "frame_compliance = 18 µm/kN, 95 %: 17.1 µm/kN to 19.2 µm/kN"}};
  for (auto const& finding :
       {named, sample::undecided(), sample::unknown(), sample::consistent()}) {
    auto const file = folder / (finding.verdict + ".html");
    std::ofstream(file) << finding_page(finding);
    EXPECT_GT(std::filesystem::file_size(file), 20'000u) << file;
  }
}

} // namespace
} // namespace coupling::finding
