#include "tests/diagnosis/broken/broken.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <string>

/// usage: broken NAME DATA -o OUT, or broken NAME DATA --of diagnosis.json -o OUT.
int main(int argc, char** argv) {
  std::string answer, out;
  for (int k = 3; k + 1 < argc; k += 2)
    (std::string(argv[k]) == "-o" ? out : answer) = argv[k + 1];
  if (argc < 5 || argc % 2 == 0 || out.empty()) {
    fmt::print(stderr,
               "usage: broken NAME DATA [--of diagnosis.json] -o OUT, with NAME one of {}\n",
               fmt::join(broken::names(), ", "));
    return 2;
  }
  try {
    auto const diagnosis = broken::diagnose(argv[1], argv[2], answer);
    std::filesystem::create_directories(out);
    std::ofstream(std::filesystem::path(out) / "diagnosis.json") << diagnosis.dump(2) << '\n';
    return 0;
  } catch (std::exception const& error) {
    fmt::print(stderr, "broken: {}\n", error.what());
    return 2;
  }
}
