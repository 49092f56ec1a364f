#include "tests/diagnosis/grains/grain_case.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <string_view>

namespace {

constexpr std::string_view usage =
    "usage: hide_grains --seed N --class clean|single [--cause NAME] [--lambda L]\n"
    "                   --code presscheck|liggghts --program PATH --case CASE --cache DIR -o DIR\n"
    "       hide_grains --class foretell --code ... --program ... --case ... --cache DIR\n";

template <class Number> Number number(std::string_view option, std::string_view text) {
  Number value{};
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw std::invalid_argument(fmt::format("{} '{}' is no number. Is it misspelt?", option, text));
  return value;
}

bool one_of(std::string_view option, std::string_view value, std::string_view first,
            std::string_view second) {
  if (value != first && value != second)
    throw std::invalid_argument(
        fmt::format("{} '{}' is neither {} nor {}. Is it misspelt?", option, value, first, second));
  return value == second;
}

struct Order {
  hidden::GrainWish wish;
  hidden::Simulations simulations{hidden::Code::own, {}, {}, {}};
  std::string_view folder;
  bool only_foretells = false;
};

void take(Order& order, std::string_view option, std::string_view value) {
  if (option == "--seed")
    order.wish.seed = number<std::uint64_t>(option, value);
  else if (option == "--class" && value == "foretell")
    order.only_foretells = true;
  else if (option == "--class")
    order.wish.is_clean = !one_of(option, value, "clean", "single");
  else if (option == "--cause")
    order.wish.cause = hidden::effect_named(value);
  else if (option == "--lambda")
    order.wish.lambda = number<double>(option, value);
  else if (option == "--code")
    order.simulations.code = one_of(option, value, "presscheck", "liggghts")
                                 ? hidden::Code::liggghts
                                 : hidden::Code::own;
  else if (option == "--program")
    order.simulations.program = value;
  else if (option == "--case")
    order.simulations.own_case = value;
  else if (option == "--cache")
    order.simulations.cache = value;
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
  if (order.simulations.program.empty() || order.simulations.cache.empty() ||
      (order.folder.empty() && !order.only_foretells))
    throw std::invalid_argument(fmt::format("--program, --cache or -o is missing. {}", usage));
  if (!(order.wish.lambda > 0.0))
    throw std::invalid_argument("--lambda is positive. Is the sign wrong?");
  return order;
}

void print(hidden::Foretold const& foretold) {
  fmt::print("lambda of the same packing pressed again {:.1f}, of another packing {:.1f}\n"
             "{:20} {:>12} {:>12} {:>8}\n",
             foretold.chaos(), foretold.packings(), "cause", "size at 16", "largest", "unit");
  for (auto const& cause : hidden::grain_causes()) {
    double const slope = foretold.per_unit(cause.effect);
    fmt::print("{:20} {:>12} {:12.3g} {:>8}\n", hidden::kind_of(cause.effect).name,
               slope > 0.0 ? fmt::format("{:.3g}", 16.0 / slope) : "not seen", cause.largest,
               cause.has_scale ? hidden::kind_of(cause.effect).unit : "knob");
  }
}

} // namespace

int main(int argc, char** argv) {
  try {
    auto const order = parse(argc, argv);
    if (order.only_foretells) {
      print(hidden::Foretold(order.simulations));
      return 0;
    }
    std::optional<hidden::Foretold> foretold;
    if (!order.wish.is_clean)
      foretold.emplace(order.simulations);
    hidden::write_grain_case(hidden::draw_grain_case(order.wish, foretold ? &*foretold : nullptr,
                                                     order.simulations.code),
                             order.simulations, order.folder);
    return 0;
  } catch (std::exception const& error) {
    fmt::print(stderr, "hide_grains: {}\n", error.what());
    return 2;
  }
}
