#include "tests/diagnosis/grains/grain_case.hpp"

#include "tests/diagnosis/hide/counter_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace hidden {
namespace {

/// Causes that this code and bed can show at half that lambda, in turn.
std::vector<GrainCause> within_reach(Foretold const& foretold, Code code, double lambda) {
  std::vector<GrainCause> all;
  for (auto const& cause : grain_causes())
    if ((code == Code::own || cause.is_in_peer) &&
        foretold.per_unit(cause.effect) * cause.largest >= 0.5 * lambda)
      all.push_back(cause);
  if (all.empty())
    throw std::invalid_argument(
        fmt::format("no cause reaches lambda {:g} on this bed. A smaller one?", lambda));
  return all;
}

GrainCause chosen(GrainWish const& wish, Foretold const& foretold, Code code) {
  auto const all = within_reach(foretold, code, wish.lambda);
  if (!wish.cause)
    return all[wish.seed % all.size()];
  auto const at = std::ranges::find(all, *wish.cause, &GrainCause::effect);
  if (at == all.end())
    throw std::invalid_argument(fmt::format("{} does not reach lambda {:g} on this bed. Another "
                                            "cause, or a smaller lambda?",
                                            kind_of(*wish.cause).name, wish.lambda));
  return *at;
}

GrainCause asked(GrainWish const& wish) {
  auto const cause = wish.cause ? grain_cause(*wish.cause) : std::nullopt;
  if (!cause)
    throw std::invalid_argument("--size is of a cause that this bed can show. Which --cause?");
  return *cause;
}

void hide_cause(GrainCase& in, GrainCause const& cause, double size) {
  in.cause = cause.effect;
  in.size = cause.has_scale ? size : 0.0;
  if (cause.place == Place::grains) {
    // Two digits, so that pools stay what they are where a pilot moves by a little.
    double const round = std::stod(fmt::format("{:.2g}", size));
    in.press = with_cause(in.press, cause.effect, round);
    in.change = fmt::format("{}-{:.2g}", kind_of(cause.effect).name, size);
  } else
    in.effects = in.effects.with(cause.effect, size);
  // The powder and the die are what they are; the laboratory has other numbers on its sheet.
  if (cause.effect == Effect::mass_error)
    in.stated_mass_share /= 1.0 + size;
  if (cause.effect == Effect::die_size)
    in.stated_bore -= size;
}

} // namespace

GrainCase draw_grain_case(GrainWish const& wish, Foretold const* foretold, Code code) {
  CounterStream powder(wish.seed, Purpose::powder), repeat(wish.seed, Purpose::repeat),
      draw(wish.seed, Purpose::size);
  GrainCase drawn{.seed = wish.seed, .press = {}, .scatter = {}, .effects = {}};
  drawn.stiffness = 1.0 + powder.uniform(-0.15, 0.15);
  drawn.stated_mass_share = 1.0 + 0.003 * repeat.normal();
  drawn.scatter = {.zero = 8e-6 * repeat.normal(), .cell_zero = 0.3 * repeat.normal()};
  drawn.stated_bore = stated_bore;
  if (!wish.is_clean) {
    auto const cause = wish.size ? asked(wish) : chosen(wish, *foretold, code);
    double const slope = wish.size ? 0.0 : foretold->per_unit(cause.effect);
    double const size = wish.size ? *wish.size : std::min(wish.lambda / slope, cause.largest);
    // What is in the grains has one sign: each costs simulations.
    bool const is_negative =
        draw.uniform() < 0.5 && !kind_of(cause.effect).is_one_sided && cause.place != Place::grains;
    drawn.lambda = slope * size;
    hide_cause(drawn, cause, is_negative && !wish.size ? -size : size);
  }
  auto const n = static_cast<std::uint64_t>(wish.n_packings);
  for (std::uint64_t k = 0; k < n; ++k)
    drawn.packings.push_back(20000 + wish.seed * n + k);
  return drawn;
}

} // namespace hidden
