#include "coupling/record/atomic_file.hpp"
#include "coupling/report/html.hpp"
#include "coupling/report/page_data.hpp"
#include "coupling/report/report.hpp"
#include "coupling/report/sections.hpp"
#include "dem/expect.hpp"
#include "tests/support/sample_report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

using coupling::ReportData;

double const nan = std::numeric_limits<double>::quiet_NaN();

struct ReportFile : ::testing::Test {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("presscheck-page-" +
       std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::string page_of(ReportData const& data) {
    coupling::write_report(folder / "report.html", data);
    return coupling::read_file(folder / "report.html");
  }
};

std::size_t count(std::string_view text, std::string_view what) {
  std::size_t n = 0;
  for (auto at = text.find(what); at != std::string_view::npos;
       at = text.find(what, at + what.size()))
    ++n;
  return n;
}

TEST(EscapeHtml, TurnsMarkupIntoText) {
  EXPECT_EQ(coupling::escape_html("<script>alert(1)</script>"),
            "&lt;script&gt;alert(1)&lt;/script&gt;");
  EXPECT_EQ(coupling::escape_html("a & b \"c\" 'd'"), "a &amp; b &quot;c&quot; &#39;d&#39;");
  EXPECT_EQ(coupling::escape_html("10 µm"), "10 µm");
}

TEST(EscapeJsonInScript, KeepsTheValueAndEndsNoScript) {
  std::string const attack = "</script><!-- & \" \\ ";
  auto const escaped = coupling::escape_json_in_script(coupling::json_text(attack));
  EXPECT_EQ(escaped.find_first_of("<>&"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(escaped).get<std::string>(), attack);
}

TEST(EscapeInlineScript, KeepsComparisonsAndBreaksClosingTags) {
  EXPECT_EQ(coupling::escape_inline_script("a<b; s='</ScRiPt>'; t='<!--'; u='</div>'"),
            "a<b; s='<\\/ScRiPt>'; t='<\\!--'; u='</div>'");
}

TEST(JsonText, ReplacesBytesThatAreNoUtf8) {
  auto const text = coupling::json_text("a\xff");
  EXPECT_EQ(nlohmann::json::parse(text).get<std::string>(), "a\uFFFD");
}

TEST(FillTemplate, DoesNotLookAtWhatItFilledIn) {
  EXPECT_EQ(coupling::fill_template("<{{a}}|{{b}}>", {{"a", "{{b}}"}, {"b", "2"}}), "<{{b}}|2>");
  EXPECT_THROW(coupling::fill_template("{{c}}", {{"a", ""}}), std::out_of_range);
}

// RFC 4648, section 10.
TEST(EncodeBase64, GivesTheVectorsOfTheStandard) {
  auto const encode = [](std::string_view text) {
    return coupling::encode_base64(std::as_bytes(std::span(text)));
  };
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foo"), "Zm9v");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encode("\xfb\xff"), "+/8=");
}

TEST(FormatQuantity, PicksTheUnitThatPeopleSay) {
  EXPECT_EQ(coupling::format_quantity(1471.0, "N"), "1.471 kN");
  EXPECT_EQ(coupling::format_quantity(8e-3, "m"), "8.000 mm");
  EXPECT_EQ(coupling::format_quantity(1000.0, "N"), "1.000 kN");
  EXPECT_EQ(coupling::format_quantity(-2.5e-5, "m", 3), "-25.0 µm");
  EXPECT_EQ(coupling::format_quantity(3.2e8, "Pa"), "320.0 MPa");
  EXPECT_EQ(coupling::format_quantity(1.234e-4, "m", 2), "123 µm");
  EXPECT_EQ(coupling::format_quantity(1.234e-4, "m", 3), "123 µm");
  EXPECT_EQ(coupling::format_quantity(1.2e-5, "m", 2), "12 µm");
  EXPECT_EQ(coupling::format_quantity(0.0, "N"), "0 N");
  EXPECT_EQ(coupling::format_quantity(0.41, "1"), "0.4100");
  EXPECT_EQ(coupling::format_quantity(nan, "N"), "not reached");
}

TEST(Verdict, SaysInWordsWhatFailed) {
  std::vector<coupling::Check> checks = {{"energy_ledger", 0.034, 0.01, false},
                                         {"force_balance", 0.002, 0.01, true}};
  auto const failed = coupling::verdict_html(checks);
  EXPECT_NE(failed.find("1 of 2 checks failed"), std::string::npos);
  EXPECT_NE(failed.find("energy ledger is 0.034, allowed 0.01"), std::string::npos);
  EXPECT_EQ(failed.find("force balance"), std::string::npos);
  checks[0].ok = true;
  EXPECT_NE(coupling::verdict_html(checks).find("All 2 checks passed"), std::string::npos);
  EXPECT_NE(coupling::verdict_html({}).find("Nothing was checked"), std::string::npos);
}

TEST(Comparison, GivesTheDifferenceRelativeToTheirs) {
  std::vector<coupling::ComparedValue> const rows = {{"max_force", "N", 1471.0, 1618.0, "paper"},
                                                     {"springback", "1", 0.1, nan, "paper"}};
  auto const table = coupling::comparison_html(rows);
  EXPECT_NE(table.find("-9.09 %"), std::string::npos); // (1471 - 1618) / 1618 = -0.09085
  EXPECT_NE(table.find("not known"), std::string::npos);
}

TEST(RecordJson, WritesNotANumberAsNullAndMarksStages) {
  coupling::PressRecord record({{"time", "s"}, {"upper_punch_force", "N"}});
  record.add_row("loading", {0.0, 1.0});
  record.add_row("loading", {0.1, nan});
  record.add_row("unloading", {0.2, std::numeric_limits<double>::infinity()});
  auto const json = nlohmann::json::parse(coupling::record_json(record));
  EXPECT_EQ(json["columns"][1]["unit"], "N");
  EXPECT_EQ(json["columns"][1]["values"][0], 1.0);
  EXPECT_TRUE(json["columns"][1]["values"][1].is_null());
  EXPECT_TRUE(json["columns"][1]["values"][2].is_null());
  EXPECT_EQ(json["stages"].size(), 2U);
  EXPECT_EQ(json["stages"][0]["last"], 1);
  EXPECT_EQ(json["stages"][1]["first"], 2);
}

TEST(RowsToDraw, ThinsALongRecordButKeepsThePeakAndTheStageEnds) {
  coupling::PressRecord record({{"upper_punch_force", "N"}, {"punch_gap", "m"}});
  for (int k = 0; k < 10000; ++k)
    record.add_row(k < 3333 ? "a" : "b", {k == 7777 ? 5.0 : 1.0, k == 5551 ? 0.5 : 1.0});
  auto const rows = coupling::rows_to_draw(record, 1000);
  EXPECT_LE(rows.size(), 1006U); // every tenth, two ends of two stages, peak, smallest gap
  EXPECT_GE(rows.size(), 1000U);
  for (std::size_t const kept : {0U, 3332U, 3333U, 5551U, 7777U, 9999U})
    EXPECT_TRUE(std::ranges::binary_search(rows, kept)) << kept;
}

TEST(GrainsToDraw, KeepsTheSurfaceOfALargeBed) {
  auto const grains = sample::grains(5000);
  EXPECT_EQ(coupling::grains_to_draw(grains).size(), 5000U);
  auto const shown = coupling::grains_to_draw(grains, 1000);
  EXPECT_LT(shown.size(), 4500U);
  std::size_t highest = 0;
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (grains[k].position.z() + grains[k].radius >
        grains[highest].position.z() + grains[highest].radius)
      highest = k;
  EXPECT_TRUE(std::ranges::binary_search(shown, highest));
}

TEST(GrainsJson, PacksSixFloatsAGrain) {
  std::vector<coupling::PicturedGrain> const grains = {{.position = dem::Vec3(1.0, 2.0, 3.0),
                                                        .radius = 0.5,
                                                        .component = 2,
                                                        .mean_overlap = 0.25,
                                                        .stress = 8.0}};
  auto const json = nlohmann::json::parse(coupling::grains_json(grains));
  // 1, 2, 3, 0.5, 0.25, 8 as little-endian binary32: 0000803f 00000040 00004040 0000003f 0000803e
  // 00000041
  EXPECT_EQ(json["numbers"], "AACAPwAAAEAAAEBAAAAAPwAAgD4AAABB");
  EXPECT_EQ(json["component"], "Ag==");
  EXPECT_EQ(json["of"], 1);
}

TEST(StressedJson, PacksPlacesTrianglesAndStress) {
  auto const json = nlohmann::json::parse(coupling::stressed_json(sample::stress_picture()));
  EXPECT_EQ(json.at("grains").at("shown"), 500);
  auto const& tool = json.at("tools").at(0);
  EXPECT_EQ(tool.at("name"), "upper_punch");
  // Bytes: 4 vertices of 3 floats, 4 triangles of 3 indices, 4 floats; base64 has 4/3 of them.
  EXPECT_EQ(tool.at("vertices").get<std::string>().size(), 64u);
  EXPECT_EQ(tool.at("triangles").get<std::string>().size(), 64u);
  // 10, 20, 30, 40 MPa as little-endian floats.
  std::vector<float> const stress{10e6f, 20e6f, 30e6f, 40e6f};
  EXPECT_EQ(tool.at("von_mises"), coupling::encode_base64(std::as_bytes(std::span(stress))));
}

TEST_F(ReportFile, HasAPlaceForStressedToolsWhereThereAreAny) {
  auto data = sample::report_data();
  EXPECT_EQ(page_of(data).find("tools-canvas\""), std::string::npos);
  data.summary.tools = {{.name = "upper_punch", .max_von_mises = 40e6}};
  data.stressed = sample::stress_picture();
  auto const page = page_of(data);
  EXPECT_NE(page.find("tools-canvas\""), std::string::npos);
  EXPECT_NE(page.find("t = 60.00 ms, cut open"), std::string::npos);
}

TEST_F(ReportFile, NeedsNothingFromOutside) {
  auto const page = page_of(sample::report_data());
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (auto const* outside :
       {"<link", "<script src", "src=\"http", "href=\"http", "@import", "url(http"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  EXPECT_LT(page.size(),
            1'300'000U); // three.js 0.85 MB, scripts 0.05, grains 3000 * 33 B = 0.1, curves 0.06
  EXPECT_GT(page.size(), 900'000U);
}

TEST_F(ReportFile, HoldsTextOfACaseAsText) {
  auto data = sample::report_data();
  std::string const attack = "<script>alert(1)</script>";
  data.title = attack;
  data.grains_moment = attack;
  data.resolved_case = "</pre>" + attack;
  data.components = {attack, "</script>"};
  data.tools[0].name = attack;
  data.observed[0] = {attack, 1.0, attack, nan, attack};
  data.comparison[0] = {attack, attack, 1.0, 2.0, attack};
  data.provenance[0] = {attack, attack};
  data.summary.mode = attack;
  data.summary.version = attack;
  data.summary.checks[0] = {attack, 1.0, 0.5, false};
  auto const page = page_of(data);
  auto const plain = page_of(sample::report_data());
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(count(page, "</script"), count(plain, "</script"));
  EXPECT_EQ(count(page, "<script"), count(plain, "<script"));
  EXPECT_EQ(count(page, "</pre>"), 1U);
}

TEST_F(ReportFile, ShowsAFailedCheckOnTop) {
  auto data = sample::report_data();
  data.summary.checks[0] = {"energy_ledger", 0.2, 0.01, false};
  auto const page = page_of(data);
  EXPECT_LT(page.find("1 of 4 checks failed"), page.find("<main>"));
}

TEST_F(ReportFile, NamesThePackageOfAMissingLibrary) {
  try {
    coupling::write_report(folder / "report.html", sample::report_data(), folder / "nowhere");
    FAIL() << "no error";
  } catch (dem::InvalidInput const& error) {
    EXPECT_NE(std::string(error.what()).find("three.min.js"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("apt-get install libjs-three"), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "report.html"));
}

} // namespace
