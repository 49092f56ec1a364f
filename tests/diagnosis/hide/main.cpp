#include "tests/diagnosis/hide/case_files.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <string_view>

namespace {

constexpr std::string_view usage =
    "usage: hide --seed N --class clean|single|double|unknown [--cause NAME]... [--size X |\n"
    "            --relative-size R] [--observables A|D|E|F|G] [--without-lambda] -o DIR\n";

template <class Number> Number number(std::string_view option, std::string_view text) {
  Number value{};
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw std::invalid_argument(fmt::format("{} '{}' is no number. Is it misspelt?", option, text));
  return value;
}

struct Order {
  hidden::Wish wish;
  std::string_view folder;
  hidden::Lambda lambda = hidden::Lambda::compute;
};

void take(Order& order, std::string_view option, std::string_view value) {
  auto& wish = order.wish;
  if (option == "--seed")
    wish.seed = number<std::uint64_t>(option, value);
  else if (option == "--class")
    wish.kind = hidden::class_named(value);
  else if (option == "--cause")
    wish.causes.push_back(hidden::effect_named(value));
  else if (option == "--size")
    wish.size = number<double>(option, value);
  else if (option == "--relative-size")
    wish.relative_size = number<double>(option, value);
  else if (option == "--observables")
    wish.observables = hidden::observables_named(value);
  else if (option == "-o")
    order.folder = value;
  else
    throw std::invalid_argument(fmt::format("{} is no option. {}", option, usage));
}

Order parse(int argc, char** argv) {
  Order order;
  for (int k = 1; k < argc; ++k) {
    std::string_view const option = argv[k];
    if (option == "--without-lambda") {
      order.lambda = hidden::Lambda::leave_out;
      continue;
    }
    if (k + 1 == argc)
      throw std::invalid_argument(fmt::format("{} has no value. {}", option, usage));
    take(order, option, argv[++k]);
  }
  if (order.folder.empty())
    throw std::invalid_argument(fmt::format("no folder is given. {}", usage));
  return order;
}

} // namespace

int main(int argc, char** argv) {
  try {
    auto const order = parse(argc, argv);
    hidden::write_case(hidden::draw_case(order.wish), order.folder, order.lambda);
    return 0;
  } catch (std::exception const& error) {
    fmt::print(stderr, "hide: {}\n", error.what());
    return 2;
  }
}
