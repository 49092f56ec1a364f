#include "tests/diagnosis/judge/bars.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <exception>
#include <string_view>

namespace {

/// A line a case: what was hidden, what was answered.
void list(std::span<judging::JudgedCase const> cases) {
  for (auto const& one : cases)
    fmt::print("{:16} {:20} {}{} {}\n", one.name, fmt::join(one.truth.causes, ", "),
               one.answer.verdict, one.answer.is_incomplete ? " incomplete" : "",
               fmt::join(one.answer.claim, ", "));
}

} // namespace

/// usage: judge [--cases] FOLDER. Exit status: 0 all bars hold, 1 one fails, 2 the folder is no set
/// of cases.
int main(int argc, char** argv) {
  bool const lists = argc == 3 && std::string_view(argv[1]) == "--cases";
  if (argc != 2 && !lists) {
    fmt::print(stderr, "usage: judge [--cases] FOLDER, with NAME/sealed/truth.json and "
                       "NAME/diagnosis/diagnosis.json in it\n");
    return 2;
  }
  try {
    auto const cases = judging::read_cases(argv[argc - 1]);
    if (lists)
      list(cases);
    return judging::print(judging::hold_bars(cases)) ? 0 : 1;
  } catch (std::exception const& error) {
    fmt::print(stderr, "judge: {}\n", error.what());
    return 2;
  }
}
