#include "tests/diagnosis/hide/cases.hpp"

#include "tests/diagnosis/hide/counter_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden {
namespace {

PlannedRun condition(double speed, double end_gap, double dwell, bool is_held_out) {
  return {.protocol = {.speed_down = speed * mm / 60.0, .end_gap = end_gap * mm, .dwell = dwell},
          .repeat = {},
          .is_held_out = is_held_out};
}

/// How many effects a class hides.
std::size_t n_hidden(CaseClass kind) {
  return kind == CaseClass::clean ? 0 : kind == CaseClass::couple ? 2 : 1;
}

/// Causes that were asked for, and drawn ones for the rest.
std::vector<Effect> draw_causes(Wish const& wish) {
  std::vector<Effect> causes = wish.causes;
  if (causes.size() > n_hidden(wish.kind))
    throw std::invalid_argument(
        fmt::format("--class {} hides {} effects, {} causes are given. Is it another class?",
                    name_of(wish.kind), n_hidden(wish.kind), causes.size()));
  bool const wants_known = wish.kind != CaseClass::unknown;
  for (auto const cause : causes)
    if ((static_cast<int>(cause) < n_known_effects) != wants_known)
      throw std::invalid_argument(fmt::format(
          "--cause {} is {} the library, --class {} hides the others. Is it another class?",
          kind_of(cause).name, wants_known ? "not in" : "in", name_of(wish.kind)));
  CounterStream draw(wish.seed, Purpose::cause);
  while (causes.size() < n_hidden(wish.kind)) {
    int const k = wants_known ? draw.below(n_known_effects)
                              : n_known_effects + draw.below(n_effects - n_known_effects);
    if (std::ranges::find(causes, static_cast<Effect>(k)) == causes.end())
      causes.push_back(static_cast<Effect>(k));
  }
  return causes;
}

/// In prior sizes: half-normal, cut where a size would be nothing or absurd; both signs where the
/// effect has two.
double draw_size(Wish const& wish, Effect effect, std::uint64_t place) {
  CounterStream draw(wish.seed, Purpose::size, place);
  double relative = std::abs(draw.normal());
  while (relative < 0.1 || relative > 2.5)
    relative = std::abs(draw.normal());
  bool const is_negative = draw.uniform() < 0.5 && !kind_of(effect).is_one_sided;
  if (wish.relative_size)
    return *wish.relative_size * kind_of(effect).prior;
  return std::max((is_negative ? -relative : relative) * kind_of(effect).prior, least_size(effect));
}

Powder draw_powder(std::uint64_t seed) {
  CounterStream draw(seed, Purpose::powder);
  Powder powder;
  powder.young_modulus *= 1.0 + draw.uniform(-0.15, 0.15);
  powder.cohesion_density *= 1.0 + draw.uniform(-0.3, 0.3);
  return powder;
}

Repeat draw_repeat(std::uint64_t seed, std::uint64_t run) {
  CounterStream draw(seed, Purpose::repeat, run);
  auto repeat = scatter_scale();
  for (double* part : {&repeat.mass, &repeat.packing, &repeat.friction, &repeat.zero,
                       &repeat.cell_zero, &repeat.mass_error})
    *part *= draw.normal();
  return repeat;
}

PlannedRun pressing_of(Extra extra, PlannedRun run) {
  auto& press = run.protocol;
  if (extra == Extra::dwell_60)
    press.dwell = 60.0;
  if (extra == Extra::dwell_600)
    press.dwell = 600.0;
  if (extra == Extra::fast)
    press.speed_down *= 25.0;
  if (extra == Extra::slow)
    press.speed_down *= 0.2;
  if (extra == Extra::wider)
    press.end_gap *= 1.05;
  return run;
}

void refuse(Wish const& wish, HiddenEffect const& hidden) {
  auto const& kind = kind_of(hidden.effect);
  double const least = least_size(hidden.effect), largest = largest_size(hidden.effect);
  if (!(hidden.size >= least && hidden.size <= largest))
    throw std::invalid_argument(
        fmt::format("{} of size {:g} {} is out of range ({:g} to {:g} are simulated). Is the unit "
                    "wrong?",
                    kind.name, hidden.size, kind.unit, least, largest));
  if (wish.size && wish.relative_size)
    throw std::invalid_argument("--size and --relative-size are both given. Which one?");
}

} // namespace

Repeat scatter_scale() {
  return {.mass = 0.003,
          .packing = 0.0012,
          .friction = 0.03,
          .zero = 8e-6,
          .cell_zero = 4.0,
          .mass_error = 0.1};
}

std::vector<PlannedRun> planned_runs(Observables set) {
  std::vector<PlannedRun> runs = {condition(1.0, 8.0, 0.0, false)};
  if (set == Observables::E || set == Observables::F || set == Observables::G)
    runs.push_back(condition(25.0, 8.0, 0.0, false));
  if (set == Observables::F || set == Observables::G) {
    runs.push_back(condition(1.0, 8.4, 0.0, false));
    runs.push_back(condition(1.0, 8.0, 60.0, false));
    runs.push_back(condition(5.0, 8.2, 0.0, false));
  }
  // 30 % more force, and five times the speed: what no fit has seen.
  runs.push_back(condition(1.0, 7.6, 0.0, true));
  runs.push_back(condition(5.0, 7.9, 0.0, true));
  return runs;
}

Effects Case::effects() const {
  Effects all;
  for (auto const& [effect, size] : hidden)
    all = all.with(effect, size);
  return all;
}

std::array<Powder, 4> simulated_departures(Powder const& powder) {
  std::array<Powder, 4> one;
  one.fill(powder);
  one[0].onset += 0.0012;
  one[1].recovery *= 1.004;
  one[2].wall_friction *= 1.02;
  one[3].radial_ratio *= 1.01;
  return one;
}

Powder simulated_powder(std::uint64_t seed) {
  CounterStream draw(seed, Purpose::simulation);
  Powder const sheet;
  auto const one = simulated_departures(sheet);
  Powder powder;
  powder.onset += draw.normal() * (one[0].onset - sheet.onset);
  powder.recovery += draw.normal() * (one[1].recovery - sheet.recovery);
  powder.wall_friction += draw.normal() * (one[2].wall_friction - sheet.wall_friction);
  powder.radial_ratio += draw.normal() * (one[3].radial_ratio - sheet.radial_ratio);
  return powder;
}

Case draw_case(Wish const& wish) {
  Case result{.seed = wish.seed,
              .kind = wish.kind,
              .observables = wish.observables,
              .powder = draw_powder(wish.seed),
              .hidden = {},
              .runs = planned_runs(wish.observables),
              .extra = wish.extra};
  for (auto const cause : draw_causes(wish)) {
    auto const place = result.hidden.size();
    double const size = wish.size && place == 0 ? *wish.size : draw_size(wish, cause, place);
    result.hidden.push_back({cause, size});
    refuse(wish, result.hidden.back());
  }
  CounterStream order(wish.seed, Purpose::order);
  auto& runs = result.runs;
  for (std::size_t k = runs.size(); k-- > 1;)
    std::swap(runs[k], runs[static_cast<std::size_t>(order.below(static_cast<int>(k) + 1))]);
  if (is_pressing(wish.extra)) // the last, so that it moves no draw of the others
    runs.push_back(pressing_of(wish.extra, planned_runs(wish.observables).front()));
  for (std::size_t k = 0; k < runs.size(); ++k) {
    runs[k].repeat = draw_repeat(wish.seed, k);
    runs[k].file = fmt::format("run{}.csv", k + 1);
  }
  return result;
}

} // namespace hidden
