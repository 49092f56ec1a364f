// How often the diagnosis is silent, right and wrong in the toy press. The README's table:
//   PRESSCHECK_RATE_SETS=40 build/release/tests/unit_diagnosis --gtest_filter='Rates.*'
#include "tests/unit/coupling/diagnosis_press.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace {

using namespace diagnosis_support;

/// Data sets a cell of the table; without the variable few, for the bars alone.
int n_sets(int usual) {
  char const* const given = std::getenv("PRESSCHECK_RATE_SETS");
  return given ? std::atoi(given) : usual;
}

struct Tally {
  int n = 0, detected = 0, alone = 0, spurious = 0, in_group = 0, unknown = 0, wrong = 0,
      covered = 0;

  void add(Diagnosis const& found, int cause, double size) {
    auto const& verdict = found.verdict;
    bool const names = std::ranges::count(verdict.causes, cause) > 0;
    bool const groups = std::ranges::count(verdict.group, cause) > 0;
    ++n;
    detected += verdict.kind != VerdictKind::consistent ? 1 : 0;
    alone += verdict.kind == VerdictKind::named && names && verdict.causes.size() == 1 ? 1 : 0;
    spurious += verdict.kind == VerdictKind::named && names && verdict.causes.size() > 1 ? 1 : 0;
    in_group += verdict.kind == VerdictKind::undecided && (groups || names) ? 1 : 0;
    unknown += verdict.kind == VerdictKind::unknown ? 1 : 0;
    wrong += (verdict.kind == VerdictKind::named && !names) ||
                     (verdict.kind == VerdictKind::undecided && !groups && !names)
                 ? 1
                 : 0;
    for (auto const& one : found.estimates)
      covered += one.mechanism == cause && one.size.low <= size && size <= one.size.high ? 1 : 0;
  }
  void print(std::string const& label) const {
    fmt::print("{:28} N {:4}  detected {:4}  alone {:4}  spurious {:3}  group {:4}  unknown {:3}  "
               "wrong {:3}  interval holds {:4}\n",
               label, n, detected, alone, spurious, in_group, unknown, wrong, covered);
  }
};

Tally single_effects(ToyPress const& press, double lambda, int sets) {
  auto const d = detectabilities(press);
  Tally tally;
  for (std::size_t j = 0; j < press.causes.size(); ++j) {
    auto const& one = press.causes[j];
    double const size = lambda / d[j];
    if (size > 3.0) // beyond what a laboratory would meet: these gauges do not see it
      continue;
    for (int set = 0; set < sets; ++set) {
      double const signed_size = set % 2 == 1 && !one.is_one_sided ? -size : size;
      tally.add(diagnose_hidden(press, {.sizes = {{one.name, signed_size}}},
                                10000 * (j + 1) + static_cast<std::uint64_t>(set)),
                static_cast<int>(j), signed_size * one.scale);
    }
  }
  return tally;
}

ToyPress press_with(Gauges gauges, int n_runs) {
  ToyPress press;
  press.gauges = gauges;
  if (n_runs > 1)
    press.runs.push_back({"run2", 10.2e-3, 1.0});
  return press;
}

} // namespace

TEST(Rates, OfFalseAlarms) {
  for (auto const& [label, press, usual] :
       {std::tuple("all gauges, 1 run", press_with(Gauges::all, 1), 60),
        std::tuple("upper force, 1 run", press_with(Gauges::upper, 1), 60),
        std::tuple("all gauges, 2 runs", press_with(Gauges::all, 2), 10)}) {
    int const n = std::getenv("PRESSCHECK_RATE_SETS") ? 50 * n_sets(0) : usual;
    int alarms = 0;
    for (int set = 0; set < n; ++set)
      alarms += diagnose_hidden(press, {.sizes = {}, .young = 0.1 * (set % 11) - 0.5},
                                300 + static_cast<std::uint64_t>(set))
                        .tests.is_alarm
                    ? 1
                    : 0;
    EXPECT_LT(alarms, 0.01 * n + 4.9 * std::sqrt(0.0099 * n) + 1.0) << label;
    fmt::print("{:28} N {:4}  false alarms {}\n", label, n, alarms);
  }
}

TEST(Rates, OfNamesAtSixteenTimesTheNoise) {
  auto const tally = single_effects(press_with(Gauges::all, 1), 16.0, n_sets(3));
  tally.print("all gauges, lambda 16");
  EXPECT_GE(tally.detected, 0.98 * tally.n);
  EXPECT_GE(tally.alone, 0.8 * tally.n);
  EXPECT_LE(tally.wrong, 0.02 * tally.n + 1.0);
  EXPECT_GE(tally.covered, 0.8 * tally.n);
}

TEST(Rates, OfNamesAtEightTimesTheNoise) {
  auto const tally = single_effects(press_with(Gauges::all, 1), 8.0, n_sets(2));
  tally.print("all gauges, lambda 8");
  EXPECT_GE(tally.detected, 0.8 * tally.n);
  EXPECT_LE(tally.wrong, 0.03 * tally.n + 1.0);
}

TEST(Rates, OfNamesByTheUpperForceAlone) {
  for (double const lambda : {8.0, 16.0}) {
    auto const tally = single_effects(press_with(Gauges::upper, 1), lambda, n_sets(2));
    tally.print(fmt::format("upper force, lambda {:g}", lambda));
    EXPECT_GE(tally.detected, 0.8 * tally.n);
    EXPECT_LE(tally.wrong, 0.1 * tally.n + 1.0);
  }
}
