#include "coupling/case_file.hpp"
#include "coupling/study/results_table.hpp"
#include "tests/unit/coupling/study_folder.hpp"

#include <set>

namespace coupling::study {
namespace {

class StudyPlanned : public StudyFolder {
protected:
  static std::vector<std::string> ids(StudyPlan const& plan) {
    std::vector<std::string> all;
    for (auto const& run : plan.runs)
      all.push_back(run.id);
    return all;
  }

  static Case case_of(StudyRun const& run) { return parse_case(run.case_text, "run.prm"); }
};

TEST_F(StudyPlanned, AFullFactorialSetsEveryEntryOfItsFactors) {
  auto const found =
      plan(design("set Kind = full_factorial\n") + factor_E() +
           factor_CED("set Levels = 5e5 J/m^3, 1e5 J/m^3, 2e5 J/m^3\n") + response());
  // The first factor changes slowest; levels need not be equally spaced.
  EXPECT_EQ(ids(found), (std::vector<std::string>{"E20_CED1e5", "E20_CED2e5", "E20_CED5e5",
                                                  "E25_CED1e5", "E25_CED2e5", "E25_CED5e5",
                                                  "E30_CED1e5", "E30_CED2e5", "E30_CED5e5"}));
  auto const setup = case_of(found.runs[7]);
  EXPECT_EQ(setup.powder.components[0].material.young_modulus, 30e6);
  EXPECT_EQ(setup.powder.components[1].material.young_modulus, 30e6);
  EXPECT_EQ(setup.tooling.material.young_modulus, 240e6);
  EXPECT_EQ(setup.contacts.grain_grain.cohesion_energy_density, 2e5);
  // (2 x 2e5 - 1e5 - 5e5) / 4e5
  EXPECT_DOUBLE_EQ(found.study.factors[1].coded(found.runs[7].natural[1]), -0.5);
}

TEST_F(StudyPlanned, CentresOfACompositeDesignAreReplicates) {
  auto const found = plan(design("set Kind = central_composite\nset Centre runs = 3\n") +
                          factor_E() + factor_CED() + response());
  ASSERT_EQ(found.runs.size(), 11u); // 4 corners, 4 axial points, 3 centres
  EXPECT_EQ(found.runs[8].id, "E25_CED350000");
  EXPECT_EQ(found.runs[10].id, "E25_CED350000_r3");
  EXPECT_EQ(case_of(found.runs[8]).powder.seed, 1u);
  EXPECT_EQ(case_of(found.runs[10]).powder.seed, 3u);
}

TEST_F(StudyPlanned, AHypercubeStaysWithinItsLimits) {
  auto const text = design("set Kind = latin_hypercube\nset Runs = 7\nset Seed = 3\n") +
                    factor_E() + factor_CED() + response();
  auto const found = plan(text);
  ASSERT_EQ(found.runs.size(), 7u);
  std::set<double> moduli;
  for (auto const& run : found.runs) {
    EXPECT_GT(run.natural[0], 20e6);
    EXPECT_LT(run.natural[0], 30e6);
    // What is planned is what the case holds, to the last bit.
    EXPECT_EQ(case_of(run).powder.components[0].material.young_modulus, run.natural[0]);
    moduli.insert(run.natural[0]);
  }
  EXPECT_EQ(moduli.size(), 7u);
  EXPECT_EQ(ids(plan(text)), ids(found));
}

TEST_F(StudyPlanned, ReplicatesFollowTheSeedOfTheCase) {
  auto const found = plan("set Case = case.prm\nsubsection Case entries\nset Powder/Packing seed = "
                          "7\nend\nsubsection Design\nset Rows = soft\nset Replicates = 3\nend\n");
  EXPECT_EQ(ids(found), (std::vector<std::string>{"soft", "soft_r2", "soft_r3"}));
  for (std::uint64_t k = 0; k < 3; ++k)
    EXPECT_EQ(case_of(found.runs[k]).powder.seed, 7 + k);
  EXPECT_NE(found.runs[0].hash, found.runs[1].hash);
}

TEST_F(StudyPlanned, ATablesFactorsTakeTheirValuesAndLimitsFromItsRows) {
  auto const found = plan(design("set Rows = soft, mid, hard\n") + factor_E("") +
                          "subsection Factor 2\nset Name = D\nset Entries = Powder/Component "
                          "2/Size classes\nend\n" +
                          response());
  EXPECT_EQ(ids(found), (std::vector<std::string>{"soft", "mid", "hard"}));
  EXPECT_EQ(found.study.factors[0].low, 20e6);
  EXPECT_EQ(found.study.factors[0].high, 30e6);
  EXPECT_EQ(found.runs[2].natural, (std::vector<double>{30e6, 1.2e-3}));
  EXPECT_EQ(case_of(found.runs[2]).powder.components[1].sizes[0].diameter, 1.2e-3);
}

TEST_F(StudyPlanned, RunsBesideATableKeepWhatItsRowsShare) {
  auto const found = plan(design("set Rows = soft, mid\n") + factor_E("") + response());
  std::vector<double> const at{21.00000004e6};
  auto const beside = runs_at(found, "validation", at, 2);
  ASSERT_EQ(beside.size(), 2u);
  EXPECT_EQ(beside[1].id, "validation_E21_r2");
  EXPECT_TRUE(beside[1].is_validation);
  auto const setup = case_of(beside[1]);
  EXPECT_EQ(setup.tooling.material.young_modulus, 168e6);
  EXPECT_EQ(setup.powder.components[1].sizes[0].diameter, 1e-3);
  EXPECT_EQ(setup.powder.seed, 2u);
}

TEST_F(StudyPlanned, ResultsAreReadInsteadOfRun) {
  auto const table = results_as_data(
      plan(design("set Rows = soft, mid\nset Results = results.csv\nset Results filter = code = "
                  "B\n") +
           factor_E("") + response("set Target = 2 kN\nset Target uncertainty = 10 N\n")));
  EXPECT_TRUE(table.response(table.study.responses[0]).isApprox(Eigen::Vector2d(1500.0, 2500.0)));
  EXPECT_TRUE(table.coded().isApprox(Eigen::Vector2d(-1.0, 1.0)));
  EXPECT_EQ(table.study.responses[0].target, 2000.0);
  EXPECT_EQ(table.study.responses[0].uncertainty, 10.0);
  EXPECT_EQ(table.rows[1].values.at("porosity").value, 0.34);
}

TEST_F(StudyPlanned, TheResolvedStudyPlansTheSameRuns) {
  auto const found = plan(design("set Kind = full_factorial\n") + factor_E() + factor_CED() +
                          response("set Target = 2 kN\n") +
                          "subsection Calibration\nset Held = CED = 3e5 J/m^3\nend\n");
  support::put_bytes(folder_ / "elsewhere.prm", found.study.resolved_text);
  auto const again = plan_study(read_study(folder_ / "elsewhere.prm"));
  ASSERT_EQ(ids(again), ids(found));
  for (std::size_t k = 0; k < found.runs.size(); ++k)
    EXPECT_EQ(again.runs[k].hash, found.runs[k].hash);
  EXPECT_EQ(again.study.calibration.held.at("CED"), 3e5);
  EXPECT_EQ(again.study.resolved_text, found.study.resolved_text);
}

} // namespace
} // namespace coupling::study
