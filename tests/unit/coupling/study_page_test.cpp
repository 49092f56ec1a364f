// What a study's page holds: of the shipped studies, of runs that failed, of hostile names.
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/curves.hpp"
#include "coupling/record/run_file.hpp"
#include "coupling/study/grain_picture.hpp"
#include "coupling/study/page_curves.hpp"
#include "coupling/study/page_tables.hpp"
#include "coupling/study/page_units.hpp"
#include "coupling/study/published.hpp"
#include "tests/support/sample_report.hpp"
#include "tests/unit/coupling/study_folder.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numbers>

namespace coupling::study {
namespace {

using Json = nlohmann::json;

bool has(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

/// A study with what was calculated from it.
struct Studied {
  StudyPlan plan;
  ResultsTable table;
  std::optional<Analysis> analysis;

  explicit Studied(StudyPlan made)
      : plan(std::move(made)), table(results_as_data(plan)), analysis(analyse_if_complete(table)) {}
  StudyPage page() const { return {table, plan, analysis}; }
};

Studied shipped(std::string const& name) {
  auto const file = std::filesystem::path(PRESSCHECK_SOURCE_DIR) / "cases/seed-study" / name;
  return Studied(plan_study(read_study(file)));
}

class StudyPageFile : public StudyFolder {
protected:
  std::string page_of(Studied const& studied) {
    write_study_page(studied.page(), folder_ / "report.html");
    return read_file(folder_ / "report.html");
  }
};

TEST(StudyPageUnits, ShowWhatPeopleSay) {
  EXPECT_EQ(short_number(1878.4921, 4), "1878");
  EXPECT_EQ(short_number(26.08), "26.08");
  EXPECT_EQ(short_number(5.0), "5");
  EXPECT_EQ(short_number(-0.012345, 3), "-0.0123");
  EXPECT_EQ(short_number(NAN), "-");
  EXPECT_EQ(decimals_of(std::vector{4.4932, 12.55, double(NAN)}), 3);
  EXPECT_EQ(decimals_of(std::vector{5.0, 3.0}), 0);
  EXPECT_EQ(fixed_number(4.4, 3), "4.400");
  EXPECT_EQ(duration_text(13.41), "13.4 s");
  EXPECT_EQ(duration_text(1.5e6), "17.4 days"); // 1.5e6 / 86400
  EXPECT_EQ(duration_text(7200.0), "2 h");
  EXPECT_EQ(duration_text(1.2e8), "3.8 years"); // 1.2e8 / 31557600
}

TEST_F(StudyPageFile, SaysTheAnswersOfTheSeedsCalibration) {
  auto const studied = shipped("calibration-liggghts.prm");
  auto const page = page_of(studied);
  EXPECT_TRUE(has(page, "<strong>9 of 9 runs finished</strong>, 0 failed."));
  EXPECT_TRUE(has(page, "Calibrated to F = 25.095 kN, P = 26.08 %, SQC = 5: E = 2231 MPa"));
  EXPECT_TRUE(has(page, "with CED held at 7e6 J/m^3"));
  EXPECT_TRUE(has(page, "The targets contradict each other"));
  EXPECT_TRUE(has(page, "P = 26.08 % is out of reach: inside the bounds its surface lies between "
                        "34.583 % and 40.026 %"));
  EXPECT_TRUE(has(page, "F alone is met at E = 2231 MPa (standard deviation 4.4 MPa)."));
  EXPECT_TRUE(has(page, "The surface of SQC foretells little: predicted R\u00b2 is -0.49"));
  // Equation (5): 40.62111 %, standard error 0.6 points: three decimals.
  EXPECT_TRUE(has(page, "<th scope=\"row\">intercept</th><td class=\"number\">40.621</td>"));
  EXPECT_TRUE(has(page, "The study as understood"));
  for (auto const* outside :
       {"<link", "<script src", "src=\"http", "href=\"http", "@import", "url(http"})
    EXPECT_FALSE(has(page, outside)) << outside;
  EXPECT_TRUE(has(page, "default-src 'none'"));
}

TEST_F(StudyPageFile, CarriesTheSeedsPorosityOnByFiveForms) {
  auto const studied = shipped("fineness-liggghts.prm");
  ASSERT_EQ(studied.analysis->trends.at(0).trend.fits.size(), 5u);
  // README of the study: 27.5 %, 23.4 to 31.6 %, with the MgO's four classes.
  auto const& packing = studied.analysis->trends[0].trend.fits[4];
  EXPECT_EQ(packing.form, "packing model, known coarse sizes");
  EXPECT_NEAR(packing.value, 0.275, 5e-4);
  EXPECT_NEAR(packing.lower, 0.234, 5e-4);
  auto const page = page_of(studied);
  EXPECT_TRUE(has(page, "P at D = 0.045 mm, which was not run: 19.288 % to 27.4"));
  EXPECT_TRUE(has(page, "(26.253 % by the linear one); measured 26.08 %."));
  auto const json = Json::parse(study_page_json(studied.page()));
  auto const& trend = json.at("trends").at(0);
  EXPECT_EQ(trend.at("observed"), 26.08);
  EXPECT_EQ(trend.at("forms").size(), 5u);
  auto const& line = trend.at("forms").at(0);
  EXPECT_EQ(line.at("x").front(), 0.045);
  EXPECT_NEAR(line.at("y").front().get<double>(), 26.2531, 1e-4);
  EXPECT_NEAR(line.at("low").front().get<double>(), 22.3432, 1e-4); // as analysis.txt says
  EXPECT_NEAR(line.at("x").back().get<double>(), 0.3, 1e-9);
}

TEST_F(StudyPageFile, DrawsTheSurfaceInTheUnitsShown) {
  auto const studied = shipped("calibration-edem.prm");
  auto const json = Json::parse(study_page_json(studied.page()));
  auto const& response = json.at("responses").at(0);
  auto const& grid = response.at("grids").at(0);
  ASSERT_EQ(grid.at("n"), 41);
  // E runs fastest: the first value is at (-1, -1), the 41st at (1, -1); equation (1) in kN.
  auto const equation = [](double E, double CED) {
    return 1e-3 * (28901.000 + 13729.333 * E - 675.667 * CED - 38.0 * E * CED + 55.0 * E * E -
                   93.0 * CED * CED);
  };
  EXPECT_NEAR(grid.at("values").at(0).get<double>(), equation(-1, -1), 1e-4);
  EXPECT_NEAR(grid.at("values").at(40).get<double>(), equation(1, -1), 1e-4);
  EXPECT_NEAR(grid.at("values").at(41 * 40).get<double>(), equation(-1, 1), 1e-4);
  EXPECT_EQ(json.at("factors").at(0).at("low"), 1375);
  EXPECT_EQ(response.at("target"), 25.095);
  EXPECT_EQ(response.at("runs").size(), 9u);
  EXPECT_EQ(response.at("runs").at(0).at("value"), 15.787);
}

TEST_F(StudyPageFile, SetsPublishedValuesBesideTheRuns) {
  support::put_bytes(folder_ / "published.csv",
                     "setup,code,max_force [kN],porosity [%]\nS,A,4,31\nS,A,9,99\nmid,A,10,\n"
                     "soft,B,2,30\n");
  auto const text = design("set Rows = soft, mid, hard\nset Results = results.csv\n"
                           "set Results filter = code = A\n") +
                    factor_E("") + "set Model = linear\n" +
                    response("set Reference scale = 0.25\n") +
                    "subsection Reference\nset Tables = published.csv\nset Rows = soft = S\nend\n";
  Studied const studied(plan(text));
  Published const published(studied.plan);
  EXPECT_EQ(published.sources(), (std::vector<std::string>{"A", "B"}));
  auto const& force = studied.table.study.responses[0];
  EXPECT_EQ(published.value("A", "soft", force), 1000.0); // a quarter of 4 kN, the first row
  EXPECT_EQ(published.value("A", "mid", force), 2500.0);
  EXPECT_TRUE(std::isnan(published.value("B", "soft", force))); // called S there
  EXPECT_TRUE(std::isnan(published.value("A", "hard", force)));
  auto const page = page_of(studied);
  EXPECT_TRUE(has(page, "<td class=\"number\">1 (+0.0 %)</td>"));
  EXPECT_TRUE(has(page, "<td class=\"number\">2.5 (-20.0 %)</td>")); // 2 against 2.5 kN
  EXPECT_TRUE(has(page, "Those of F are taken times 0.25."));
}

TEST_F(StudyPageFile, RefusesPublishedRowsThatAreNotThere) {
  auto const message = [&](std::string const& rows) {
    Studied const studied(
        plan(design("set Rows = soft, mid\nset Results = results.csv\n"
                    "set Results filter = code = B\n") +
             factor_E("") + "set Model = linear\n" + response() +
             "subsection Reference\nset Tables = results.csv\nset Rows = " + rows + "\nend\n"));
    try {
      page_of(studied);
      return std::string("accepted");
    } catch (dem::InvalidInput const& problem) {
      return without_folder(problem.what());
    }
  };
  EXPECT_EQ(message("soft = hard"), "accepted");
  EXPECT_EQ(message("sott = hard"), "study.prm:18: Reference/Rows = sott = hard: 'sott' is no "
                                    "set-up of this study. Did you mean 'soft'?");
  EXPECT_EQ(message("soft = hrad"),
            "study.prm:18: Reference/Rows = soft = hrad: 'hrad' is no row of "
            "the tables. Did you mean 'hard'?");
}

TEST_F(StudyPageFile, ListsFailedRunsAndHoldsTextAsText) {
  std::string const attack = "<script>alert(1)</script>";
  Studied studied = shipped("screening-edem.prm");
  auto const plain = page_of(studied);
  studied.table.rows[3].state = RunState::failed;
  studied.table.rows[3].reason = "the overlap guard tripped " + attack;
  studied.table.study.title = attack;
  studied.table.study.resolved_text = "</pre>" + attack;
  studied.table.study.responses[0].name = attack;
  studied.analysis = analyse_if_complete(studied.table);
  EXPECT_FALSE(studied.analysis.has_value());
  auto const page = page_of(studied);
  EXPECT_TRUE(has(page, "<strong>14 of 15 runs finished</strong>, 1 failed."));
  EXPECT_TRUE(has(page, "nothing is fitted to it"));
  EXPECT_TRUE(has(page, studied.table.rows[3].run.id + ": failed, the overlap guard tripped"));
  EXPECT_FALSE(has(page, "<script>alert"));
  auto const count = [](std::string const& text, std::string const& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      ++n;
    return n;
  };
  EXPECT_EQ(count(page, "</script"), count(plain, "</script"));
  EXPECT_EQ(count(page, "</pre>"), 1u);
}

TEST_F(StudyPageFile, ThinsTheCurvesAndKeepsThePeak) {
  Studied studied = shipped("screening-edem.prm");
  auto const record = sample::record(4000);
  write_curves(folder_ / "curves.csv", record);
  studied.table.rows[1].folder = folder_.path();
  auto const json = Json::parse(curves_json(studied.table, 100));
  ASSERT_EQ(json.at("runs").size(), 1u);
  auto const& run = json.at("runs").at(0);
  EXPECT_EQ(run.at("run"), studied.table.rows[1].run.id);
  EXPECT_LE(run.at("time").size(), 106u);
  EXPECT_GE(run.at("time").size(), 100u);
  auto const forces = run.at("upper_punch_force").get<std::vector<double>>();
  auto const all = record.column("upper_punch_force");
  EXPECT_NEAR(std::ranges::max(forces), std::ranges::max(all), 0.05); // five digits of 1471 N
  ASSERT_EQ(json.at("stages").size(), 2u);
  EXPECT_EQ(json.at("stages").at(0).at("name"), "loading");
  EXPECT_NEAR(json.at("stages").at(0).at("to").get<double>(), 0.06, 1e-4);
  EXPECT_TRUE(Json::parse(shapes_json(studied.table, 120)).at("runs").empty());
}

TEST(GrainPicture, IsADiscThatTheNearerGrainCovers) {
  dem::Spheres grains;
  grains.add(dem::Vec3{0.0, 0.0, 5.0}, 4.0, 1000.0, 0);
  auto const frame = frame_of(grains);
  EXPECT_EQ(frame.half_width, 4.0);
  EXPECT_EQ(frame.bottom, 0.0); // never above the floor
  EXPECT_EQ(frame.top, 9.0);
  auto const alone = draw_grains(grains, frame, 80);
  EXPECT_EQ(alone.width, 80);
  EXPECT_EQ(alone.height, 90); // 9 of 8
  auto const n = std::ranges::count_if(alone.pixels, [](auto p) { return p != 0; });
  EXPECT_NEAR(static_cast<double>(n), std::numbers::pi * 40.0 * 40.0, 40.0); // 0.8 % of the disc
  auto const at = [](GrainPicture const& picture, double x, double z) {
    auto const row = static_cast<int>((9.0 - z) * 10.0),
               column = static_cast<int>((x + 4.0) * 10.0);
    return int{
        picture.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                       static_cast<std::size_t>(column)]};
  };
  EXPECT_EQ(at(alone, 0.01, 5.01), 63);              // faces the viewer
  EXPECT_NEAR(at(alone, 2.4, 5.0), 1 + 62 * 0.8, 1); // cos a = sqrt(1 - 0.6^2)
  EXPECT_EQ(at(alone, 0.0, 0.5), 0);
  // A grain of component 1 before it, one behind it.
  grains.add(dem::Vec3{0.0, -5.0, 5.0}, 1.0, 1000.0, 1);
  grains.add(dem::Vec3{0.0, 6.0, 5.0}, 2.0, 1000.0, 2);
  auto const three = draw_grains(grains, frame, 80);
  EXPECT_EQ(at(three, 0.01, 5.01), 64 + 63);
  EXPECT_LT(at(three, 1.5, 5.0), 64);
  EXPECT_EQ(common(frame, {5.0, -1.0, 2.0}).half_width, 5.0);
  EXPECT_EQ(common(frame, {5.0, -1.0, 2.0}).bottom, -1.0);
  EXPECT_EQ(common(frame, {5.0, -1.0, 2.0}).top, 9.0);
}

} // namespace
} // namespace coupling::study
