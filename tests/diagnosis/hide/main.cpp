#include "tests/diagnosis/hide/case_files.hpp"
#include "tests/diagnosis/hide/detectability.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace {

constexpr std::string_view usage =
    "usage: hide --seed N --class clean|single|double|unknown [--cause NAME]... [--size X |\n"
    "            --relative-size R | --lambda L] [--observables A|D|E|F|G]\n"
    "            [--also MEASUREMENT] [--foretell nothing|lambda|separation] -o DIR\n";

template <class Number> Number number(std::string_view option, std::string_view text) {
  Number value{};
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw std::invalid_argument(fmt::format("{} '{}' is no number. Is it misspelt?", option, text));
  return value;
}

hidden::Foretold foretold_named(std::string_view name) {
  if (name == "nothing")
    return hidden::Foretold::nothing;
  if (name == "lambda")
    return hidden::Foretold::lambda;
  if (name == "separation")
    return hidden::Foretold::separation;
  throw std::invalid_argument(
      fmt::format("--foretell '{}' is none of nothing, lambda, separation. Is it misspelt?", name));
}

struct Order {
  hidden::Wish wish;
  std::string_view folder;
  std::optional<double> lambda = {}; ///< wanted of each effect
  hidden::Foretold foretold = hidden::Foretold::lambda;
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
  else if (option == "--also")
    wish.extra = hidden::extra_named(value);
  else if (option == "--lambda")
    order.lambda = number<double>(option, value);
  else if (option == "--foretell")
    order.foretold = foretold_named(value);
  else if (option == "-o")
    order.folder = value;
  else
    throw std::invalid_argument(fmt::format("{} is no option. {}", option, usage));
}

Order parse(int argc, char** argv) {
  Order order;
  for (int k = 1; k < argc; ++k) {
    std::string_view const option = argv[k];
    if (k + 1 == argc)
      throw std::invalid_argument(fmt::format("{} has no value. {}", option, usage));
    take(order, option, argv[++k]);
  }
  if (order.folder.empty())
    throw std::invalid_argument(fmt::format("no folder is given. {}", usage));
  if (order.lambda && (order.wish.size || order.wish.relative_size || !(*order.lambda > 0.0)))
    throw std::invalid_argument("--lambda is positive and stands alone (it sets the size). "
                                "Leave --size and --relative-size out?");
  return order;
}

} // namespace

int main(int argc, char** argv) {
  try {
    auto const order = parse(argc, argv);
    auto hidden_case = hidden::draw_case(order.wish);
    if (order.lambda && !hidden_case.hidden.empty()) {
      hidden::Detector const detector(hidden_case);
      for (auto& hidden : hidden_case.hidden)
        hidden.size = detector.size_for(hidden, *order.lambda);
    }
    hidden::write_case(hidden_case, order.folder, order.foretold);
    return 0;
  } catch (std::exception const& error) {
    fmt::print(stderr, "hide: {}\n", error.what());
    return 2;
  }
}
