#pragma once

#include "coupling/breakage_law.hpp"
#include "coupling/elastic/coupling_choice.hpp"
#include "coupling/load_cell.hpp"
#include "coupling/press_frame.hpp"
#include "dem/contact/contact_choice.hpp"
#include "dem/material.hpp"
#include "dem/vec3.hpp"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

/// What the user wrote, in SI units, defaults filled in. Immutable after reading.
namespace coupling {

struct SizeClass {
  double diameter;      ///< [m]
  double mass_fraction; ///< [1], of its component
};

struct Component {
  dem::Material material;       ///< name, density, Young's modulus, Poisson's ratio
  double mass_fraction;         ///< [1], of the powder
  std::vector<SizeClass> sizes; ///< fractions sum to 1
};

/// Grains finer than any of the powder's own size classes, as a real powder has them: every
/// component gives this share of its mass to grains of its own material and this size.
struct AddedFines {
  double share = 0.0;    ///< [1]
  double diameter = 0.0; ///< [m]
};

enum class FillMethod { random, file, state };

struct Powder {
  std::vector<Component> components; ///< their sizes hold the fines, as the last class of each
  AddedFines fines;
  double total_mass = 9.13e-3; ///< [kg]
  FillMethod fill_method = FillMethod::random;
  std::filesystem::path fill_file; ///< packing CSV, or a restart file / run folder for `state`
  double fill_height = 20e-3;      ///< [m], of the virtual cylinder (the bore's diameter)
  std::uint64_t seed = 1;
  double settle_time = 0.0; ///< [s], free fall under gravity before the first stage; 0 = none
  double fill_state = 0.0;  ///< [1], share of static friction that is missing while grains settle
};

struct Contacts {
  dem::ContactChoice law; ///< after presets
  dem::Interaction grain_grain;
  dem::Interaction grain_wall; ///< its cohesion_energy_density is the particle-wall one
};

enum class WallKind { surface, analytic };

struct Tooling {
  WallKind walls = WallKind::surface;
  double bore_diameter = 22.05e-3; ///< [m]
  double die_height = 20e-3;       ///< [m], bore from z = 0 upwards
  double wall_thickness = 10e-3;   ///< [m], die
  double punch_length = 10e-3;     ///< [m]
  double punch_tilt = 0.0; ///< [m], rise of the upper punch's face across the bore, from -x to +x
  double chordal_tolerance = 1e-5;                                    ///< [m]
  std::filesystem::path die_file, upper_punch_file, lower_punch_file; ///< STL; empty = generated
  double stl_scale = 1.0; ///< [m] per unit of the STL files
  dem::Material material{"wall", 8000.0, 200e6, 0.29};

  /// dz/dx of the upper punch's face [1].
  double punch_slope() const { return punch_tilt / bore_diameter; }
};

/// Gap of the punch faces over the time since a stage began.
struct GapPath {
  std::vector<double> time; ///< [s], from 0, increasing
  std::vector<double> gap;  ///< [m], > 0
};

enum class StageKind { move, hold, release, free, follow };
enum class Limit { time, gap, force, flush };

/// One phase of the press programme.
///  - move: the tool moves with `speed` (positive up) until the limit; `force` stops when the tool
///  carries that force, `flush` when the lower punch's face is level with the die's rim: ejection
///  - hold: the tools stand still for `duration`; or the servo keeps `force` on the tool for
///  `duration`
///  - release: the named tools vanish at once (duration 0)
///  - free: nothing is driven for `duration`
///  - follow: one punch keeps the gap at that of `path`, straight from point to point
struct Stage {
  std::string name; ///< unique, e.g. "loading"
  StageKind kind = StageKind::move;
  std::vector<std::string> tools; ///< die, upper_punch, lower_punch
  double speed = 0.0;             ///< [m/s], along z
  Limit until = Limit::time;
  double duration = 0.0; ///< [s], also the longest a gap or force limit may take (0: no bound)
  double gap = 0.0;      ///< [m], between the punch faces
  double force = 0.0;    ///< [N]
  bool servo = false;    ///< hold: keep `force`
  std::filesystem::path follow_file = {}; ///< follow: where the path is measured
  double time_scale = 1.0;                ///< [1], follow: simulated over measured time
  GapPath path = {};                      ///< follow: read when the press is set up
};

struct TimeStepping {
  double rayleigh_fraction = 0.1;
  bool adaptive = false;
  double safety = 0.8;               ///< of the stable step, adaptive only
  double max_relative_overlap = 1.8; ///< guard, of the smaller radius
  double max_energy_error = 0.1;     ///< guard, of the work done so far
};

struct Output {
  double record_interval = 2.5e-4;     ///< [s], of curves.csv
  double snapshot_interval = 5e-3;     ///< [s], of grains.pvd; 0 = none
  double restart_interval = 600.0;     ///< [s] of wall clock
  double core_diameter_fraction = 0.7; ///< of the bore, for porosity_core
};

struct Case {
  std::string title = "untitled";
  std::string mode = "rigid";
  Powder powder;
  Contacts contacts;
  BreakageLaw breakage;
  Tooling tooling;
  ElasticTools elastic;
  FrameLaw frame;
  LoadCellErrors load_cell;
  std::vector<Stage> stages;
  TimeStepping time_stepping;
  Output output;
  dem::Vec3 gravity = dem::Vec3(0.0, 0.0, -9.81);
  std::filesystem::path file; ///< where it was read from
  std::string resolved_text;  ///< the full case as understood, .prm
};

} // namespace coupling
