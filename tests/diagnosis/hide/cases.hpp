#pragma once

#include "tests/diagnosis/hide/press.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hidden {

enum class CaseClass { clean, single, couple, unknown };

/// What a laboratory has: diagnosis note 4.1.
///   A  upper force, one run      D  all gauges, one run      E  all gauges, two speeds
///   F  upper force and height, five runs                     G  all gauges, five runs
enum class Observables { A, D, E, F, G };

/// One more thing that is measured, beside the set: a number of the fitted pressings, or one more
/// pressing.
enum class Extra {
  nothing,
  compact_height,   ///< by a caliper
  compact_mass,     ///< by a balance
  compact_diameter, ///< by a bore gauge, where the bed was pressed
  gap_at_peak,      ///< by a gauge between the faces
  dead_weight,      ///< what the cell shows of 10 kN
  dwell_60,
  dwell_600, ///< [s]
  fast,      ///< 25 times the speed
  slow,      ///< a fifth of it
  wider      ///< an end gap 5 % larger
};
/// @throws std::invalid_argument for a name that is none
Extra extra_named(std::string_view name);
/// Whether it is a pressing of its own.
bool is_pressing(Extra extra);

struct HiddenEffect {
  Effect effect;
  double size; ///< [unit of its kind]
};

/// What the command line asks for; what it leaves open is drawn.
struct Wish {
  std::uint64_t seed = 1;
  CaseClass kind = CaseClass::clean;
  Observables observables = Observables::D;
  std::vector<Effect> causes = {};
  std::optional<double> size = {};          ///< of the first cause [its unit]
  std::optional<double> relative_size = {}; ///< of all, in prior sizes
  Extra extra = Extra::nothing;
};

struct PlannedRun {
  Protocol protocol;
  Repeat repeat;
  bool is_held_out = false;
  std::string file = {};
};

/// Everything about a case: with the seed, its data to the bit.
struct Case {
  std::uint64_t seed;
  CaseClass kind;
  Observables observables;
  Powder powder;
  std::vector<HiddenEffect> hidden;
  std::vector<PlannedRun> runs; ///< in the order of the files
  Extra extra = Extra::nothing;
  Effects effects() const;
};

/// @throws std::invalid_argument where the wish contradicts itself
Case draw_case(Wish const& wish);

/// The conditions of an observable set, the held-out ones last.
std::vector<PlannedRun> planned_runs(Observables observables);

/// Scatter between pressings that are meant to be the same: mass 0.3 %, onset 0.0012, wall friction
/// 3 %, zeros 8 um and 4 N (standard deviations). Source: diagnosis note 4.1.
Repeat scatter_scale();

/// What a simulation of a powder is not sure of, one standard deviation of one number each.
std::array<Powder, 4> simulated_departures(Powder const& powder);

/// The powder as a simulation of the press has it: at the sheet's modulus and cohesion, each other
/// number off by what packing seeds and time steps make of it (standard deviations: onset 0.0012,
/// recovery 0.4 %, wall friction 2 %, radial ratio 1 %).
Powder simulated_powder(std::uint64_t seed);

bool has_all_gauges(Observables observables);
bool has_compact_height(Observables observables);

CaseClass class_named(std::string_view name);
Observables observables_named(std::string_view name);
std::string_view name_of(CaseClass kind);
std::string_view name_of(Observables observables);

} // namespace hidden
