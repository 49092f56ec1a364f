// A study from its file to what is said: the shipped studies of the seed's tables, and what a
// design must hold before anything is run.
#include "coupling/record/atomic_file.hpp"
#include "coupling/study/analysis.hpp"
#include "dem/expect.hpp"
#include "tests/support/near.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace coupling::study {
namespace {

ResultsTable results(std::filesystem::path const& file) {
  return results_as_data(plan_study(read_study(file)));
}
ResultsTable shipped(std::string const& name) {
  return results(std::filesystem::path(PRESSCHECK_SOURCE_DIR) / "cases/seed-study" / name);
}

std::string refusal(std::filesystem::path const& file) {
  try {
    validate_model(plan_study(read_study(file)));
    return "accepted";
  } catch (dem::InvalidInput const& problem) {
    std::string const message = problem.what();
    auto const at = message.find(file.string());
    return at == 0 ? "FILE" + message.substr(file.string().size()) : message;
  }
}

// Equations (4) and (5) of the paper as printed, in newtons and percent.
TEST(StudyAnalysis, OfTable7GivesThePapersEquations) {
  Analysis const analysis = analyse(shipped("calibration-liggghts.prm"));
  ASSERT_EQ(analysis.responses.size(), 3u);
  std::array<std::array<double, 6>, 2> const printed{
      {{29026.111, 13763.667, -617.0, -4.5, 23.333, -23.667},
       {40.62111, 3.07667, -3.68333, -0.355, -0.50667, 0.87333}}};
  std::array<double, 2> const unit{1.0, 100.0}, rounding{5.001e-4, 5.001e-6};
  for (std::size_t r = 0; r < 2; ++r) {
    auto const coefficients = analysis.responses[r].surface.coefficients();
    ASSERT_EQ(coefficients.size(), 6u);
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(unit[r] * coefficients[c].value, printed[r][c], rounding[r])
          << r << " " << coefficients[c].name;
  }
}

// CED is held at 7e6 J/m^3: the force alone gives the paper's moduli to 1 MPa.
TEST(StudyAnalysis, OfTable7GivesThePapersModuli) {
  for (auto const& [file, modulus] :
       {std::pair{"calibration-edem.prm", 2250e6}, {"calibration-liggghts.prm", 2230e6}}) {
    Analysis const analysis = analyse(shipped(file));
    ASSERT_EQ(analysis.roots.at(0).response, "F");
    ASSERT_EQ(analysis.roots[0].roots.size(), 1u);
    EXPECT_NEAR(analysis.roots[0].roots[0].value, modulus, 1e6) << file;
    ASSERT_TRUE(analysis.calibration.has_value());
    EXPECT_TRUE(analysis.calibration->contradicts); // the porosity is out of reach
    EXPECT_EQ(calibrated_point(analysis).at(1), 7e6);
  }
}

TEST(StudyAnalysis, OfTable8CarriesThePorosityOn) {
  Analysis const analysis = analyse(shipped("fineness-liggghts.prm"));
  ASSERT_EQ(analysis.trends.size(), 1u);
  EXPECT_EQ(analysis.trends[0].trend.fits.at(0).form, "linear");
  EXPECT_NEAR(analysis.trends[0].trend.fits[0].value, 0.2625, 5e-5); // 26.25 %
  EXPECT_GT(analysis.trends[0].trend.highest - analysis.trends[0].trend.lowest, 0.05);
}

TEST(StudyAnalysis, OfTable6RanksTheFactors) {
  EXPECT_EQ(analyse(shipped("screening-liggghts.prm")).influences.at(1).factor, "CED");
  EXPECT_EQ(analyse(shipped("screening-edem.prm")).influences.at(1).factor, "D");
}

TEST(StudyAnalysis, IsKeptBesideTheResults) {
  support::ScratchFolder const folder;
  auto const table = shipped("calibration-liggghts.prm");
  write_results(table, folder.path());
  Analysis const analysis = analyse(table);
  write_analysis(analysis, table.study, folder.path());
  auto const json = nlohmann::json::parse(read_file(folder / "study.json"));
  EXPECT_EQ(json.at("runs").size(), 9u);
  auto const& kept = json.at("analysis");
  EXPECT_EQ(kept.at("model"), "quadratic");
  EXPECT_EQ(kept.at("responses").at(0).at("coefficients").at(1).at("value"),
            analysis.responses[0].surface.coefficients()[1].value);
  EXPECT_EQ(kept.at("calibration").at("contradicts"), true);
  EXPECT_NE(read_file(folder / "analysis.txt").find("F alone is met at E = 2230.85 MPa"),
            std::string::npos);
}

// Share, index and coarse sizes are those of the plan; a force is no porosity.
TEST(StudyAnalysis, MakesThePackingFormOfThePlan) {
  std::vector<double> const sizes{0.2e-3, 0.3e-3}, porosities{0.3, 0.35};
  ExtrapolationPlan wanted{
      .factor = "D", .value = 1e-4, .responses = {}, .forms = {"linear", "packing_model"}};
  wanted.packing = {.fine_share = 0.3, .compaction_index = 4.1, .coarse = {}};
  std::vector<std::string> left_out;
  Eigen::VectorXd const free{{0.7, std::log(2e-3)}}, one = free.head(1);
  auto forms = trend_forms(wanted, sizes, porosities, left_out);
  ASSERT_EQ(forms.size(), 2u);
  EXPECT_EQ(forms[1].value(free, 1e-4), packing_form(0.3, 4.1, 0.3e-3).value(free, 1e-4));
  EXPECT_EQ(forms[1].low[1], std::log(0.3e-3)); // the coarse size is no finer than the fines
  wanted.packing.coarse = {{1e-3, 0.4}, {2e-3, 0.6}};
  forms = trend_forms(wanted, sizes, porosities, left_out);
  EXPECT_EQ(forms[1].value(one, 1e-4),
            packing_form({{1e-3, 0.4, 0.5}, {2e-3, 0.6, 0.5}}, 0.3, 4.1).value(one, 1e-4));
  EXPECT_TRUE(left_out.empty());
  EXPECT_EQ(trend_forms(wanted, sizes, {1500.0, 1600.0}, left_out).size(), 1u);
  ASSERT_EQ(left_out.size(), 1u);
  EXPECT_EQ(left_out[0], "packing model: a response is no porosity (between 0 and 1)");
}

// With CED free, too, the region of E and CED stands in study.json, and ends at the bound of CED.
TEST(StudyAnalysis, KeepsTheJointRegion) {
  support::ScratchFolder const folder;
  auto text = read_file(PRESSCHECK_SOURCE_DIR "/cases/seed-study/calibration-liggghts.prm");
  for (auto at = text.find("../"); at != std::string::npos; at = text.find("../"))
    text.replace(at, 3, PRESSCHECK_SOURCE_DIR "/cases/");
  std::string const held = "  set Held = CED = 7e6 J/m^3\n";
  text.erase(text.find(held), held.size());
  support::put_bytes(folder / "study.prm", text);
  auto const table = results(folder / "study.prm");
  write_results(table, folder.path());
  write_analysis(analyse(table), table.study, folder.path());
  auto const json = nlohmann::json::parse(read_file(folder / "study.json"));
  auto const& region = json.at("analysis").at("calibration").at("region").at(0);
  EXPECT_EQ(region.at("factors"), (std::vector<std::string>{"E", "CED"}));
  // chi^2 = 57.58 at the best point, and 5.99 more.
  EXPECT_NEAR(region.at("chi_squared").get<double>(), 57.58 + 5.9915, 0.01);
  ASSERT_EQ(region.at("lines").size(), 1u);
  auto const& line = region.at("lines").at(0);
  EXPECT_EQ(line.front().at(1), 7e6);
  EXPECT_EQ(line.back().at(1), 7e6);
  for (auto const& point : line)
    EXPECT_NEAR(point.at(0).get<double>(), 2230e6, 15e6);
}

// Known before a run is made: three runs do not hold the six terms of two factors.
TEST(StudyAnalysis, RefusesADesignThatDoesNotHoldItsModel) {
  support::ScratchFolder const folder;
  auto const study = [&](std::string const& model, std::string const& levels) {
    auto file = folder / "study.prm";
    support::put_bytes(
        file, "set Case = " PRESSCHECK_SOURCE_DIR "/cases/quick/case.prm\nset Model = " + model +
                  "\nsubsection Design\n  set Kind = full_factorial\nend\n"
                  "subsection Factor 1\n  set Name = E\n"
                  "  set Entries = Powder/Component 1/Young's modulus\n"
                  "  set Low = 200 MPa\n  set High = 300 MPa\n  set Levels = " +
                  levels +
                  "\nend\nsubsection Response 1\n  set Name = F\n"
                  "  set Quantity = max_force\nend\n");
    return file;
  };
  EXPECT_EQ(refusal(study("quadratic", "3")), "accepted");
  EXPECT_EQ(refusal(study("linear", "2")), "accepted");
  std::string const message = refusal(study("quadratic", "2"));
  EXPECT_TRUE(message.starts_with("FILE: Model = quadratic: ")) << message;
  EXPECT_NE(message.find("3 terms"), std::string::npos) << message;
  EXPECT_TRUE(refusal(study("cubic", "3")).starts_with("FILE:2: Model = cubic"))
      << refusal(study("cubic", "3"));
}

} // namespace
} // namespace coupling::study
