#include "coupling/compare/compare.hpp"

#include "coupling/commands/commands.hpp"

#include <algorithm>
#include <iostream>
#include <iterator>

namespace coupling::commands {

int compare(CompareOptions const& options) {
  std::vector<Source> sources;
  for (auto const& path : options.sources)
    std::ranges::move(read_sources(path), std::back_inserter(sources));
  auto const comparison = coupling::compare(std::move(sources));
  std::filesystem::path const page = options.file.empty() ? "comparison.html" : options.file;
  write_comparison(page, comparison);
  std::cout << in_words(comparison) << '\n';
  for (auto const& sentence : comparison.missing)
    std::cout << "not compared: " << sentence << '\n';
  std::cout << "comparison: " << page.string() << '\n';
  return done;
}

} // namespace coupling::commands
