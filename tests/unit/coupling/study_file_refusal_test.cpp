#include "coupling/study/results_table.hpp"
#include "tests/unit/coupling/study_folder.hpp"

namespace coupling::study {
namespace {

class StudyRefused : public StudyFolder {
protected:
  std::string of_results(std::string const& text) {
    try {
      results_as_data(plan(text));
      return "accepted";
    } catch (dem::InvalidInput const& problem) {
      return without_folder(problem.what());
    }
  }
};

TEST_F(StudyRefused, ForItsEntries) {
  EXPECT_EQ(refusal("set Titel = x\n"),
            "study.prm:1: Titel = x: is no entry of a study. Did you mean 'Title'?");
  EXPECT_EQ(
      refusal("subsection Desing\nend\n"),
      "study.prm:1: subsection Desing: is no section of a study (there are: Calibration, Case "
      "entries, Cost, Design, Extrapolation, Factor #, Reference, Response #). Did you mean "
      "'Design'?");
  EXPECT_EQ(refusal("subsection Factor 1\nset Nam = E\nend\n"),
            "study.prm:2: Factor 1/Nam = E: is no entry of a study. Did you mean 'Factor 1/Name'?");
  EXPECT_EQ(
      refusal("subsection Case entries\nset Powder/Total mas = 1 g\nend\n"),
      "study.prm:2: Powder/Total mas = 1 g: is no entry of a case. Did you mean 'Powder/Total "
      "mass'?");
  EXPECT_EQ(refusal("set Title = x\n"),
            "study.prm: Case is not set (the case that the runs change). Add 'set Case = ...'?");
  EXPECT_EQ(refusal("set Case = cas.prm\n"),
            "study.prm:1: Case = cas.prm: is no file (looked for cas.prm; paths start at the study "
            "file). Is it misspelt?");
  EXPECT_EQ(
      refusal(design("set Kind = factorial\n")),
      "study.prm:3: Design/Kind = factorial: is none of the choices (table | full_factorial | "
      "central_composite | latin_hypercube). Choose one of them?");
  EXPECT_EQ(refusal(design("set Runs = 4\n")),
            "study.prm:3: Design/Runs = 4: is not used (Design/Kind = table). Remove it?");
}

TEST_F(StudyRefused, ForItsFactors) {
  auto const full = design("set Kind = full_factorial\n");
  EXPECT_EQ(refusal(full), "study.prm:3: Design/Kind = full_factorial: has no factor to vary (only "
                           "a table can do without). Add 'subsection Factor 1'?");
  EXPECT_EQ(
      refusal(full + "subsection Factor 1\nset Name = E\nset Entries = Powder/Density\nend\n"),
      "study.prm:7: Factor 1/Entries = Powder/Density: 'Powder/Density' is no entry of a "
      "case. See all entries with: presscheck defaults?");
  EXPECT_EQ(refusal(full + "subsection Factor 1\nset Name = E\nset Entries = Mode\nend\n"),
            "study.prm:7: Factor 1/Entries = Mode: 'Mode' holds no number (a factor is a number). "
            "Make a table with this entry as a column?");
  EXPECT_EQ(
      refusal(full + factor_E("set Low = 20 MPa\nset High = 20 MPa\n")),
      "study.prm:9: Factor 1/High = 20 MPa: is Low, too (factor 'E' would be constant). Widen "
      "it, or move it to 'Case entries'?");
  EXPECT_EQ(
      refusal(full + factor_E("set Low = 20 mm\nset High = 20 MPa\n")),
      "study.prm:8: Factor 1/Low = 20 mm: has a unit that does not fit (a modulus or pressure "
      "is needed). Write it in Pa, kPa, MPa, GPa?");
  EXPECT_EQ(refusal(full + factor_E("set Low = 20 MPa\nset High = 30 MPa\nset Levels = 1\n")),
            "study.prm:10: Factor 1/Levels = 1: is no number of levels (2 to 100) and no list of "
            "levels (a factor with one level is constant). Write 3, or 1375 MPa, 2500 MPa?");
  EXPECT_EQ(refusal(full + factor_E() + response() +
                    "subsection Case entries\nset Tooling/Young's modulus = 1 GPa\nend\n"),
            "study.prm:7: Factor 1/Entries = Powder/Component 1/Young's modulus + Powder/Component "
            "2/Young's modulus + 8 x To...: 'Tooling/Young's modulus' is set by 'Case entries' "
            "(study.prm:16), too (one of them would be lost). Remove one?");
  EXPECT_EQ(refusal(full + factor_E("set Low = 20 Pa\nset High = 30 MPa\n") + response()),
            "study.prm:7: Powder/Component 1/Young's modulus = 20 Pa: is outside the allowed range "
            "(>= 100000 Pa, <= 2000000000000 Pa). Did you mean 20 MPa?");
}

TEST_F(StudyRefused, ForItsRows) {
  EXPECT_EQ(
      refusal(design("set Rows = soft, hrad\n")),
      "study.prm:3: Design/Rows = soft, hrad: settings.csv: has no setup 'hrad' (it lists 4). "
      "Did you mean one of hard, mid, odd?");
  EXPECT_EQ(refusal(design("set Rows = soft, soft\n")),
            "study.prm:3: Design/Rows = soft, soft: names 'soft' twice. Name it once?");
  EXPECT_EQ(refusal(design("set Rows = soft\n") + factor_E("") + response()),
            "study.prm:7: factor 'E' = 20 MPa in all 1 rows (a constant cannot be fitted). Other "
            "rows, or without this factor?");
  EXPECT_EQ(
      refusal(design("") + factor_E("") + response()),
      "settings.csv:5: Tooling/Young's modulus = 200 MPa: does not follow factor 'E' = 35 MPa "
      "(its Entries in study.prm say 8 times the value). Correct one of them?");
  EXPECT_EQ(
      refusal(design("set Rows = soft, mid\n") + factor_E("") + factor_CED("") + response()),
      "settings.csv:2: setup 'soft' says nothing of Contact/Particle-particle/Cohesion energy "
      "density (factor 'CED' of study.prm:11 takes its value from there). Add the column, or "
      "leave out the factor?");
  support::put_bytes(folder_ / "settings.csv", "setup,Title\na b,x\na_b,y\n");
  EXPECT_EQ(refusal(design("")), "settings.csv:3: run 'a_b' has the name of another one, 'a b' "
                                 "(settings.csv:2): its folder would be 'a_b', too. Rename one?");
}

TEST_F(StudyRefused, ForItsResponsesAndResults) {
  auto const read = design("set Rows = soft, hard\nset Results = results.csv\nset Results filter = "
                           "code = B\n");
  EXPECT_EQ(refusal(read + factor_E("")),
            "study.prm: has factors but no response (nothing could be fitted to them). Add "
            "'subsection Response 1'?");
  EXPECT_EQ(refusal(read + factor_E("") +
                    "subsection Response 1\nset Name = P\nset Quantity = "
                    "porosty\nend\n"),
            "study.prm:13: Response 1/Quantity = porosty: is no number that the results have "
            "(max_force, porosity). Did you mean 'porosity'?");
  EXPECT_EQ(refusal(read + factor_E("") + response("set Target = 2 mm\n")),
            "study.prm:14: Response 1/Target = 2 mm: has a unit that does not fit (a force is "
            "needed). Write it in N, kN?");
  EXPECT_EQ(of_results(read + factor_E("") + response()),
            "results.csv: has no row of 'hard', code = B (settings.csv:4 runs it). Add the row, or "
            "leave out the run?");
  EXPECT_EQ(of_results(design("set Rows = soft, hard\nset Results = results.csv\n") + factor_E("") +
                       response()),
            "results.csv:5: is a second row of 'soft' (first on line 2). Which one is meant? Set "
            "'Design/Results filter'?");
}

TEST_F(StudyRefused, ForReplicatesThatCouldNotDiffer) {
  support::put_bytes(folder_ / "packing.csv",
                     "x [m],y [m],z [m],diameter [m],component\n0,0,2e-3,1e-3,MgO\n");
  EXPECT_EQ(refusal("set Case = case.prm\nsubsection Case entries\nset Powder/Fill method = file\n"
                    "set Powder/Fill file = packing.csv\nend\nsubsection Design\nset Rows = soft\n"
                    "set Replicates = 2\nend\n"),
            "study.prm:8: Design/Replicates = 2: makes 2 runs of 'soft' that are all the same "
            "(Powder/Fill method is not random, so no packing seed is read). Write 1?");
}

TEST_F(StudyRefused, ForWhatTheFitWasToUse) {
  auto const full = design("set Kind = full_factorial\n") + factor_E() + response();
  EXPECT_EQ(refusal(full + "subsection Calibration\nset Held = CED = 1\nend\n"),
            "study.prm:16: Calibration/Held = CED = 1: 'CED' is no factor of this study. Which one "
            "is meant?");
  EXPECT_EQ(refusal(full + "subsection Calibration\nset Validation = true\nend\n"),
            "study.prm:16: Calibration/Validation = true: has nothing to aim at (no response has a "
            "Target). Add one?");
  EXPECT_EQ(refusal(full + "subsection Extrapolation\nset Factor = E\nend\n"),
            "study.prm: Extrapolation/Value is not set (where to extrapolate to). Add 'set Value = "
            "...'?");
}

TEST_F(StudyRefused, ForTheFormsOfAnExtrapolation) {
  auto const carried = design("set Kind = full_factorial\n") + factor_E() + response() +
                       "subsection Extrapolation\nset Factor = E\nset Value = 40 MPa\n";
  EXPECT_EQ(refusal(carried + "set Forms = linear, packing\nend\n"),
            "study.prm:18: Extrapolation/Forms = linear, packing: 'packing' is no form (there are: "
            "linear, quadratic, logarithmic, power, packing_model). Which one is meant?");
  EXPECT_EQ(refusal(carried + "set Forms = linear, linear\nend\n"),
            "study.prm:18: Extrapolation/Forms = linear, linear: names 'linear' twice. Name it "
            "once?");
  EXPECT_EQ(
      refusal(carried + "set Fine share = 20 %\nend\n"),
      "study.prm:18: Extrapolation/Fine share = 20 %: is not used (packing_model is not among "
      "Extrapolation/Forms). Add it there?");
  EXPECT_EQ(refusal(carried + "set Forms = packing_model\nend\n"),
            "study.prm: Extrapolation/Fine share is not set (packing_model mixes fines and coarse "
            "grains). Add 'set Fine share = ...'?");
  EXPECT_EQ(refusal(carried + "set Forms = packing_model\nset Fine share = 120 %\nend\n"),
            "study.prm:19: Extrapolation/Fine share = 120 %: is outside the allowed range (> 0, < "
            "1). Choose a value inside it?");
  EXPECT_EQ(refusal(carried + "set Forms = packing_model\nset Fine share = 20 %\n"
                              "set Coarse sizes = 1 mm: 60 %, 2 mm: 30 %\nend\n"),
            "study.prm:20: Extrapolation/Coarse sizes = 1 mm: 60 %, 2 mm: 30 %: has shares that "
            "make 90 % (the coarse grains are 100 %). Is a class missing?");
}

TEST_F(StudyRefused, ForItsCostAndItsReferences) {
  auto const full = design("set Kind = full_factorial\n") + factor_E() + response();
  EXPECT_EQ(refusal(full + "subsection Cost\nset Predict at = 1\nend\n"),
            "study.prm:16: Cost/Predict at = 1: is not used (Cost/Factor is empty). Name the "
            "factor?");
  EXPECT_EQ(refusal(full + "subsection Cost\nset Factor = grain\nend\n"),
            "study.prm:16: Cost/Factor = grain: 'grain' is no factor of this study. Which one is "
            "meant?");
  EXPECT_EQ(refusal(full + "subsection Cost\nset Factor = grains\nset Predict at = 1e5, 0\nend\n"),
            "study.prm:17: Cost/Predict at = 1e5, 0: '0' is not above 0 (a power law has no value "
            "there). Which size is meant?");
  EXPECT_EQ(refusal(full + "subsection Cost\nset Factor = E\nset Predict at = 4 mm\nend\n"),
            "study.prm:17: Cost/Predict at = 4 mm: '4 mm' has a unit that does not fit (a modulus "
            "or pressure is needed). Write it in Pa, kPa, MPa, GPa?");
  EXPECT_EQ(refusal(full + "subsection Reference\nset Tables = results.csv, other.csv\nend\n"),
            "study.prm:16: Reference/Tables = results.csv, other.csv: is no file (looked for "
            "other.csv; paths start at the study file). Is it misspelt?");
  EXPECT_EQ(refusal(full + "subsection Reference\nset Rows = a = b\nend\n"),
            "study.prm:16: Reference/Rows = a = b: is not used (Reference/Tables is empty). Name "
            "the tables?");
  auto const targeted = design("set Kind = full_factorial\n") + factor_E() +
                        response("set Target = 1 kN\nset Observed = 1 kN\n");
  EXPECT_EQ(
      refusal(targeted),
      "study.prm:15: Response 1/Observed = 1 kN: is not used (Target says what was measured). "
      "Remove one of the two?");
  EXPECT_EQ(refusal(design("set Kind = full_factorial\n") + factor_E() +
                    response("set Reference scale = 0\n")),
            "study.prm:14: Response 1/Reference scale = 0: is outside the allowed range (> 0). "
            "Choose a value inside it?");
}

} // namespace
} // namespace coupling::study
