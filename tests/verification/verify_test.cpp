#include "coupling/verification/benchmarks.hpp"
#include "coupling/verification/verify.hpp"
#include "dem/expect.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace {

using namespace coupling::verification;

std::vector<std::string> experiment_names() {
  std::vector<std::string> names;
  for (Experiment const& experiment : all_experiments())
    names.push_back(experiment.name);
  return names;
}

class Verification : public ::testing::TestWithParam<std::string> {};

// What `presscheck verify` shows to a user must hold in every build.
TEST_P(Verification, HoldsItsTolerances) {
  for (Experiment const& experiment : all_experiments()) {
    if (experiment.name != GetParam())
      continue;
    for (Benchmark const& row : experiment.run()) {
      EXPECT_TRUE(row.ok) << row.name << ": " << row.result << " against " << row.reference
                          << ", error " << row.error << " > " << row.tolerance;
      EXPECT_TRUE(row.name.starts_with(experiment.name.substr(0, experiment.name.find('/'))))
          << row.name;
      EXPECT_FALSE(row.source.empty()) << row.name;
      // However much of the row's name a filter holds, its experiment runs.
      for (std::size_t length = 0; length <= row.name.size(); ++length) {
        auto const chosen = experiments_for(row.name.substr(0, length));
        EXPECT_TRUE(std::ranges::count(chosen, experiment.name, &Experiment::name) == 1)
            << row.name.substr(0, length);
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Rows, Verification, ::testing::ValuesIn(experiment_names()),
                         [](auto const& p) {
                           std::string name = p.param;
                           for (char& c : name) {
                             if (!std::isalnum(static_cast<unsigned char>(c)))
                               c = '_';
                           }
                           return name;
                         });

TEST(Compare, FailsOnNanAndJudgesZeroAbsolutely) {
  EXPECT_FALSE(compare("a", 1.0, std::nan(""), 1e9, "s").ok);
  EXPECT_FALSE(compare("a", std::nan(""), 1.0, 1e9, "s").ok);
  EXPECT_TRUE(compare("a", 0.0, 1e-3, 1e-3, "s").ok);
  EXPECT_FALSE(compare("a", 0.0, 2e-3, 1e-3, "s").ok);
  EXPECT_NEAR(compare("a", -2.0, -2.1, 0.1, "s").error, 0.05, 1e-12);
}

TEST(RunBenchmarks, FiltersByPartOfTheRowsName) {
  auto const rows = run_benchmarks("free_fall");
  ASSERT_EQ(rows.size(), 3u);
  std::set<std::string> names;
  for (Benchmark const& row : rows)
    names.insert(row.name);
  EXPECT_EQ(names.size(), rows.size());
  EXPECT_EQ(run_benchmarks("free_fall/position").size(), 1u);
  EXPECT_TRUE(run_benchmarks("no such thing").empty());
}

// The finite elements stand in the same list: 4 + 1 + 1 + 4 + 2 + 2 + 4 + 2 rows of problems.hpp.
TEST(RunBenchmarks, HasTheProblemsOfElasticity) {
  auto const rows = run_benchmarks("elasticity");
  std::set<std::string> names;
  for (Benchmark const& row : rows) {
    names.insert(row.name);
    EXPECT_TRUE(row.ok) << row.name;
    EXPECT_EQ(row.name.find_first_of(" :,[]"), std::string::npos) << row.name;
  }
  EXPECT_EQ(rows.size(), 20u);
  EXPECT_EQ(names.size(), rows.size());
  EXPECT_TRUE(names.contains("elasticity/tube_in_plane_strain/von_Mises_stress_at_the_bore"));
  EXPECT_TRUE(names.contains("elasticity/beams/cantilever_deflection_of_the_end"));
  // Lame, plane strain, 65.7 MPa: 5.46424 um
  auto const bore = run_benchmarks("elasticity/tube_in_plane_strain/u_r_at_the_bore");
  ASSERT_EQ(bore.size(), 1u);
  EXPECT_NEAR(bore[0].reference, 5.46424e-6, 1e-11);
}

// Grains' rows do not wait for finite elements, and a row's full name runs its experiment alone.
TEST(RunBenchmarks, RunsOnlyExperimentsThatAFilterCanMean) {
  auto const n_chosen = [](std::string const& filter) {
    auto const chosen = experiments_for(filter);
    auto const n_elastic = std::ranges::count_if(
        chosen, [](Experiment const& one) { return one.name.starts_with("elasticity/"); });
    return std::pair(static_cast<std::ptrdiff_t>(chosen.size()) - n_elastic, n_elastic);
  };
  using Counts = std::pair<std::ptrdiff_t, std::ptrdiff_t>;
  for (char const* grains : {"hertz", "free_fall/position", "chung_ooi/7", "integrator/order"}) {
    EXPECT_GT(n_chosen(grains).first, 0) << grains;
    EXPECT_EQ(n_chosen(grains).second, 0) << grains;
  }
  EXPECT_EQ(n_chosen("elasticity"), Counts(0, 8));
  EXPECT_EQ(n_chosen("elasticity/tube"), Counts(0, 2));
  EXPECT_EQ(n_chosen("elasticity/column"), Counts(0, 1));
  EXPECT_EQ(n_chosen("elasticity/column/shortening"), Counts(0, 1));
  EXPECT_EQ(n_chosen("").second, 8);
}

TEST(VerificationFiles, HoldWhatTheContractSays) {
  auto const folder = std::filesystem::temp_directory_path() / "presscheck_verify_test";
  std::filesystem::create_directories(folder);
  std::vector<Benchmark> const rows{
      compare("one", 2.0, 2.0, 1e-3, "<script>alert(1)</script> & \"quotes\""),
      compare("lost", 1.0, std::nan(""), 1e-3, "nowhere")};
  write_json(rows, folder / "verification.json");
  write_html(rows, folder / "verification.html");
  auto const list = nlohmann::json::parse(std::ifstream(folder / "verification.json"));
  ASSERT_EQ(list.size(), 2u);
  for (char const* key : {"name", "reference", "result", "error", "tolerance", "ok", "source"}) {
    EXPECT_TRUE(list[0].contains(key)) << key;
  }
  EXPECT_EQ(list[0]["name"], "one");
  EXPECT_TRUE(list[0]["ok"]);
  EXPECT_TRUE(list[1]["result"].is_null());
  EXPECT_FALSE(list[1]["ok"]);
  std::ifstream page(folder / "verification.html");
  std::string const html((std::istreambuf_iterator<char>(page)), {});
  EXPECT_EQ(html.find("<script"), std::string::npos) << "text is escaped";
  EXPECT_EQ(html.find("http"), std::string::npos) << "the page needs nothing from outside";
  EXPECT_NE(html.find("1 failed"), std::string::npos);
  std::filesystem::remove_all(folder);
  EXPECT_THROW(write_json(rows, folder / "verification.json"), dem::InvalidInput);
}

} // namespace
