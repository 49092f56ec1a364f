// What a run that has not been made would take, against the closed form of a line of logarithms.
#include "coupling/record/atomic_file.hpp"
#include "coupling/study/analysis.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/study_folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace coupling::study {
namespace {

class StudyCost : public StudyFolder {
protected:
  /// Runs of alumina sizes with processor times [s] and grains; a negative number is left out.
  CostAnalysis analysis(std::vector<double> const& sizes, std::vector<double> const& seconds,
                        std::vector<double> const& grains, std::string const& cost) {
    std::string settings = "setup,Powder/Component 2/Size classes\n";
    std::string results = "setup,max_force [N],cpu_seconds [s],grains [1]\n";
    auto const told = [](double value) { return value < 0.0 ? "" : std::to_string(value); };
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      settings += fmt::format("s{},{} mm: 100 %\n", k, sizes[k]);
      results += fmt::format("s{},{},{},{}\n", k, 10.0 + static_cast<double>(k % 2),
                             told(seconds[k]), told(grains[k]));
    }
    support::put_bytes(folder_ / "settings.csv", settings);
    support::put_bytes(folder_ / "results.csv", results);
    table_ =
        results_as_data(plan(design("set Results = results.csv\n") +
                             "set Model = linear\nsubsection Factor 1\nset Name = D\n"
                             "set Entries = Powder/Component 2/Size classes as {}: 100 %\nend\n" +
                             response() + "subsection Cost\n" + cost + "end\n"));
    return analyse_cost(*table_);
  }

  std::optional<ResultsTable> table_; ///< of the latest analysis
};

/// Straight line of ln y on ln x at a place: value and 95 % prediction interval, by sums.
struct ByHand {
  double value, lower, upper;

  ByHand(std::vector<double> const& x, std::vector<double> const& y, double at, double student) {
    auto const n = static_cast<double>(x.size());
    double mx = 0.0, my = 0.0, sxx = 0.0, sxy = 0.0, rss = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k)
      mx += std::log(x[k]) / n, my += std::log(y[k]) / n;
    for (std::size_t k = 0; k < x.size(); ++k) {
      sxx += std::pow(std::log(x[k]) - mx, 2);
      sxy += (std::log(x[k]) - mx) * (std::log(y[k]) - my);
    }
    double const b = sxy / sxx;
    for (std::size_t k = 0; k < x.size(); ++k)
      rss += std::pow(std::log(y[k]) - my - b * (std::log(x[k]) - mx), 2);
    double const middle = my + b * (std::log(at) - mx);
    double const reach = student * std::sqrt(rss / (n - 2.0)) *
                         std::sqrt(1.0 + 1.0 / n + std::pow(std::log(at) - mx, 2) / sxx);
    value = std::exp(middle);
    lower = std::exp(middle - reach);
    upper = std::exp(middle + reach);
  }
};

std::vector<double> const sizes_of_runs{1.0, 0.8, 0.6, 0.5};              // [mm]
std::vector<double> const seconds_of_runs{10.0, 24.0, 61.0, 130.0};       // about D^-3.7
std::vector<double> const grains_of_runs{1000.0, 1900.0, 4500.0, 8100.0}; // about D^-3
double const student_of_2 = 4.302652729911275; // 95 %, two degrees of freedom

TEST_F(StudyCost, IsForetoldWithItsIntervalAgainstASize) {
  auto const cost = analysis(sizes_of_runs, seconds_of_runs, grains_of_runs,
                             "set Factor = D\nset Predict at = 0.3 mm\n");
  ASSERT_EQ(cost.forecasts.size(), 1u);
  auto const& found = cost.forecasts[0];
  ByHand const time(sizes_of_runs, seconds_of_runs, 0.3, student_of_2),
      count(sizes_of_runs, grains_of_runs, 0.3, student_of_2);
  EXPECT_DOUBLE_EQ(found.at, 0.3e-3);
  EXPECT_TRUE(near::relative(found.seconds.value, time.value, 1e-9));
  EXPECT_TRUE(near::relative(found.seconds.run_lower, time.lower, 1e-9));
  EXPECT_TRUE(near::relative(found.seconds.run_upper, time.upper, 1e-9));
  EXPECT_TRUE(near::relative(found.grains.value, count.value, 1e-9));
  EXPECT_TRUE(near::relative(found.grains.run_upper, count.upper, 1e-9));
  // 200 MB and 1000 B a grain
  EXPECT_TRUE(near::relative(found.bytes, 200e6 + 1000.0 * count.value, 1e-9));
  EXPECT_TRUE(near::relative(found.bytes_upper, 200e6 + 1000.0 * count.upper, 1e-9));
  ASSERT_EQ(cost.statements.size(), 2u);
  EXPECT_EQ(cost.statements[0], "4 runs leave 2 degrees of freedom: the intervals are wide because "
                                "the runs are few.");
  EXPECT_EQ(cost.statements[1],
            "D = 0.3 mm lies outside the runs (0.5 mm to 1 mm), 1.67 times beyond the nearest: the "
            "interval holds if the power law does.");
}

TEST_F(StudyCost, IsForetoldAgainstTheNumberOfGrains) {
  auto const cost = analysis(sizes_of_runs, seconds_of_runs, grains_of_runs,
                             "set Factor = grains\nset Predict at = 2000, 2e4\n");
  ASSERT_EQ(cost.forecasts.size(), 2u);
  for (auto const& found : cost.forecasts) {
    ByHand const time(grains_of_runs, seconds_of_runs, found.at, student_of_2);
    EXPECT_TRUE(near::relative(found.seconds.value, time.value, 1e-9));
    EXPECT_TRUE(near::relative(found.seconds.run_upper, time.upper, 1e-9));
    EXPECT_EQ(found.bytes, 200e6 + 1000.0 * found.at);
  }
  EXPECT_EQ(cost.forecasts[1].at, 2e4);
  EXPECT_FALSE(cost.grains.has_value());
}

// Without a size of its own, the cost is foretold where the responses are carried to.
TEST_F(StudyCost, IsForetoldWhereTheTrendGoes) {
  auto const cost = analysis(sizes_of_runs, seconds_of_runs, grains_of_runs,
                             "set Factor = D\nend\nsubsection Extrapolation\nset Factor = D\n"
                             "set Value = 0.4 mm\n");
  ASSERT_EQ(cost.forecasts.size(), 1u);
  EXPECT_EQ(cost.forecasts[0].at, 0.4e-3);
}

TEST_F(StudyCost, SaysWhatTheRunsDoNotTell) {
  auto const two = analysis({1.0, 0.8, 0.6}, {10.0, 24.0, -1.0}, {-1.0, -1.0, -1.0},
                            "set Factor = D\nset Predict at = 0.9 mm\n");
  ASSERT_EQ(two.statements.size(), 2u);
  EXPECT_EQ(two.statements[0], "2 of 3 runs tell their processor time.");
  EXPECT_EQ(two.statements[1], "Two runs fix a power law and leave nothing to judge it by: no "
                               "interval can be stated.");
  EXPECT_TRUE(std::isfinite(two.forecasts.at(0).seconds.value));
  EXPECT_TRUE(std::isnan(two.forecasts[0].seconds.run_upper));
  EXPECT_TRUE(std::isnan(two.forecasts[0].bytes));
  auto const one = analysis({1.0, 0.8}, {10.0, -1.0}, {1.0, -1.0}, "set Factor = D\n");
  EXPECT_FALSE(one.law.has_value());
  EXPECT_EQ(one.statements.back(),
            "Processor time is no power law of D yet: the runs that tell it have fewer than two "
            "different values of D.");
}

TEST_F(StudyCost, StandsInTheFolder) {
  auto const cost = analysis(sizes_of_runs, seconds_of_runs, grains_of_runs,
                             "set Factor = D\nset Predict at = 0.3 mm\n");
  write_results(*table_, folder_.path());
  write_analysis(analyse(*table_), table_->study, folder_.path());
  auto const& found = cost.forecasts.at(0);
  auto const text = read_file(folder_ / "analysis.txt");
  auto const line = fmt::format(
      "  a run at D = 0.3 mm would take {:.3g} s (95 %: {:.3g} to {:.3g} s) and at most "
      "{:.3g} GB: {:.3g} grains",
      found.seconds.value, found.seconds.run_lower, found.seconds.run_upper, 1e-9 * found.bytes,
      found.grains.value);
  EXPECT_NE(text.find(line), std::string::npos) << text << line;
  EXPECT_NE(text.find("4 runs leave 2 degrees of freedom"), std::string::npos);
  auto const json = nlohmann::json::parse(read_file(folder_ / "study.json"));
  auto const& kept = json.at("analysis").at("cost");
  EXPECT_EQ(kept.at("exponent"), cost.law->exponent);
  EXPECT_EQ(kept.at("forecasts").at(0).at("cpu_seconds").at("high"), found.seconds.run_upper);
  EXPECT_EQ(kept.at("forecasts").at(0).at("bytes"), found.bytes);
  EXPECT_EQ(kept.at("statements").size(), 2u);
}

} // namespace
} // namespace coupling::study
