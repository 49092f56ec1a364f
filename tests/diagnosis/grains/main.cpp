#include "tests/diagnosis/grains/grain_case.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace {

constexpr std::string_view usage =
    "usage: hide_grains --seed N --class clean|single [--cause NAME] [--lambda L | --size X] "
    "[--packings N]\n"
    "                   --program PRESSCHECK [--peer LIGGGHTS] --case CASE --cache DIR -o DIR\n"
    "       hide_grains --class foretell [--packings N] --program PRESSCHECK --case CASE --cache "
    "DIR\n";

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
  std::string_view program, peer, own_case, folder;
  std::filesystem::path cache;
  bool only_foretells = false;

  hidden::Simulations own() const {
    return {hidden::Code::own, std::string(program), std::string(own_case), cache / "presscheck"};
  }
  /// Where the data come from.
  hidden::Simulations data() const {
    return peer.empty() ? own()
                        : hidden::Simulations{
                              hidden::Code::liggghts, std::string(peer), {}, cache / "liggghts"};
  }
};

void take(Order& order, std::string_view option, std::string_view value) {
  if (option == "--seed")
    order.wish.seed = number<std::uint64_t>(option, value);
  else if (option == "--class" && value == "foretell")
    order.only_foretells = true;
  else if (option == "--packings")
    order.wish.n_packings = number<int>(option, value);
  else if (option == "--class")
    order.wish.is_clean = !one_of(option, value, "clean", "single");
  else if (option == "--cause")
    order.wish.cause = hidden::effect_named(value);
  else if (option == "--lambda")
    order.wish.lambda = number<double>(option, value);
  else if (option == "--size")
    order.wish.size = number<double>(option, value);
  else if (option == "--program")
    order.program = value;
  else if (option == "--peer")
    order.peer = value;
  else if (option == "--case")
    order.own_case = value;
  else if (option == "--cache")
    order.cache = value;
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
  if (order.program.empty() || order.own_case.empty() || order.cache.empty() ||
      (order.folder.empty() && !order.only_foretells))
    throw std::invalid_argument(
        fmt::format("--program, --case, --cache or -o is missing. {}", usage));
  if (!(order.wish.lambda > 0.0) || order.wish.n_packings < 1)
    throw std::invalid_argument("--lambda and --packings are positive. Is a sign wrong?");
  return order;
}

void print(hidden::Foretold const& foretold) {
  fmt::print("a packing scatters by {:.2g} % of its force ({:g} between channels)\n"
             "{:20} {:>12} {:>12} {:>8}\n",
             100.0 * foretold.bed_scatter(), foretold.bed_correlation(), "cause", "size at 16",
             "largest", "unit");
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
    auto const own = order.own(), data = order.data();
    std::optional<hidden::Foretold> foretold;
    if ((!order.wish.is_clean && !order.wish.size) || order.only_foretells)
      foretold.emplace(own, order.wish.n_packings);
    if (order.only_foretells)
      print(*foretold);
    else
      hidden::write_grain_case(
          hidden::draw_grain_case(order.wish, foretold ? &*foretold : nullptr, data.code), data,
          order.folder);
    return 0;
  } catch (std::exception const& error) {
    fmt::print(stderr, "hide_grains: {}\n", error.what());
    return 2;
  }
}
