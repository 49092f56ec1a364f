#pragma once

#include "coupling/diagnosis/model.hpp"
#include "coupling/reduced/press_chain.hpp"

#include <string_view>

namespace coupling::reduced {

/// A bed in its machine: what a hypothesis changes.
struct Press {
  PressedBed pressed;
  Machine machine;
  double solid_density = 0.0;    ///< [kg/m^3], of the grains; 0 where no mass is asked for
  double cohesion_density = 0.0; ///< cohesion energy density of the simulation [J/m^3]
};

/// dS/dCED [Pa m^3/J]: the force falls by 1.5 % at the peak for each MJ/m^3, linearly, whatever E
/// is. Source: cases/seed-library.
inline constexpr double cohesion_slope = 2.5;

/// Where a cause acts: on the machine, the die and the mass, which the emulator has exactly; or
/// between the grains, which a simulation must be asked for.
enum class Side { machine, grains };

/// A known cause: its prior, and what it does to a press.
struct Cause {
  diagnosis::Mechanism mechanism;
  /// @param size    [unit of the mechanism]
  /// @param shapes  its shape parameters, in the mechanism's order
  void (*apply)(Press& press, double size, Eigen::VectorXd const& shapes);
  Side side;
};

/// Every cause of the outward contract. Young's modulus and cohesion are calibrated within their
/// sheets; as causes they are what a sheet that is wrong leaves over.
/// Prior sizes: the largest that a competent laboratory would meet. Source: diagnosis note, 4.2;
/// die_compliance and multi_contact: README.
std::vector<Cause> const& known_causes();

/// What scatters from pressing to pressing that is meant to be the same, standard deviations.
/// Source: diagnosis note, 4.1.
struct RepeatScatter {
  double mass = 0.003;         ///< [1], relative
  double onset = 0.0012;       ///< [1], packing
  double wall_friction = 0.03; ///< [1], relative
  double gap_zero = 8e-6;      ///< [m]
  double force_zero = 4.0;     ///< [N], of a cell that is good to 12 N
};
std::vector<diagnosis::Scatter> scatters_of(RepeatScatter const& scatter);

/// @param departure  in the order of scatters_of, [their units]
void apply_scatter(Press& press, Eigen::VectorXd const& departure);

} // namespace coupling::reduced
