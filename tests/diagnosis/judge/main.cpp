#include "tests/diagnosis/judge/advice.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <exception>
#include <filesystem>

namespace {

void list(std::span<judging::JudgedCase const> cases) {
  for (auto const& one : cases)
    fmt::print("{:16} {:20} {}{} {}\n", one.name, fmt::join(one.truth.causes, ", "),
               one.answer.verdict, one.answer.is_incomplete ? " incomplete" : "",
               fmt::join(one.answer.claim, ", "));
}

} // namespace

/// Exit status: 0 all bars hold, 1 one fails, 2 the folder is no set of cases.
int main(int argc, char** argv) {
  CLI::App app("Holds the bars of the diagnosis note against diagnoses of hidden effects.",
               "judge");
  std::filesystem::path folder;
  bool lists = false, asks = false, was_advised = false;
  double level = judging::usual_level;
  app.add_option("FOLDER", folder, "with NAME/sealed/truth.json and NAME/diagnosis/diagnosis.json")
      ->required();
  app.add_flag("--cases", lists, "a line a case: what was hidden, what was answered");
  auto* const asked = app.add_flag(
      "--advised", asks,
      "cases with a recommended measurement: NAME SEED OBSERVABLES CAUSE SIZE MEASUREMENT");
  app.add_flag("--next", was_advised, "they were measured once more, as recommended: B8 alone")
      ->excludes(asked);
  app.add_option("--level", level, "of each bar's binomial test")->check(CLI::Range(1e-12, 0.5));
  try {
    app.parse(argc, argv);
  } catch (CLI::ParseError const& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    if (asks) {
      for (auto const& one : judging::advised_cases(folder))
        fmt::print("{} {} {} {} {} {}\n", one.name, one.seed, one.observables, one.cause, one.size,
                   one.measurement);
      return 0;
    }
    auto const cases = judging::read_cases(folder);
    if (lists)
      list(cases);
    auto const results = was_advised ? std::vector{judging::hold_advice(cases, level)}
                                     : judging::hold_bars(cases, level);
    return judging::print(results) ? 0 : 1;
  } catch (std::exception const& error) {
    fmt::print(stderr, "judge: {}\n", error.what());
    return 2;
  }
}
