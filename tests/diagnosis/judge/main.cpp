#include "tests/diagnosis/judge/bars.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>

/// usage: judge FOLDER. Exit status: 0 all bars hold, 1 one fails, 2 the folder is no set of cases.
int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: judge FOLDER, with NAME/sealed/truth.json and "
                       "NAME/diagnosis/diagnosis.json in it\n");
    return 2;
  }
  try {
    auto const cases = judging::read_cases(argv[1]);
    return judging::print(judging::hold_bars(cases)) ? 0 : 1;
  } catch (std::exception const& error) {
    fmt::print(stderr, "judge: {}\n", error.what());
    return 2;
  }
}
