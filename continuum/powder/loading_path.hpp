#pragma once

#include "continuum/powder/material_point.hpp"

#include <string>
#include <vector>

/// Laboratory tests on one point of powder, without a mesh: z is the axis. Each function moves the
/// point along and gives its rows, the start's first, so tests can follow one another.
namespace continuum {

/// Columns of equal length, stresses positive in compression.
struct LoadingPath {
  std::vector<double> height_ratio;     ///< h/h_0 = F_zz [-]
  std::vector<double> relative_density; ///< D of the unloaded powder, D_0 exp(eps_v^p) [-]
  std::vector<double> axial_stress;     ///< s_z [Pa]
  std::vector<double> radial_stress;    ///< s_r, mean of s_x and s_y [Pa]
  std::vector<double> shear_stress;     ///< s_xz [Pa]
  std::vector<double> pressure;         ///< p [Pa]
  std::vector<double> deviator;         ///< q [Pa]
  std::vector<double> stress_ratio;     ///< K_0 = s_r/s_z [-]; NaN without axial stress
  std::vector<double> plastic_work;     ///< [J/m^3 of the start's volume]
  std::vector<PowderSurface> surface;

  std::size_t size() const { return height_ratio.size(); }
  void append(LoadingPath const& next); ///< without its first row, which is this one's last
};

/// Uniaxial strain to a height h/h_0, in equal steps of the height.
/// @throws SolverFailure if a step fails, with its reason: all drivers do
LoadingPath press_to_height(PowderLaw const& law, PowderPoint& point, double height_ratio,
                            int n_steps);

/// Uniaxial strain to an axial stress [Pa, compression positive], in equal steps of the stress;
/// each solves for the height by Newton's iteration. Zero unloads.
LoadingPath press_to_stress(PowderLaw const& law, PowderPoint& point, double axial_stress,
                            int n_steps);

/// F = J^(1/3) I to a volume ratio J of the start, in equal steps of its logarithm.
LoadingPath compress_isotropically(PowderLaw const& law, PowderPoint& point, double volume_ratio,
                                   int n_steps);

/// Triaxial compression: axial logarithmic strain added in equal steps (compression positive) while
/// the radial stress stays as it is, solved by Newton's iteration on the tangent.
LoadingPath compress_triaxially(PowderLaw const& law, PowderPoint& point, double axial_strain,
                                int n_steps);

/// Simple shear at constant height: F = (I + gamma e_x e_z) F_start, in equal steps of gamma.
LoadingPath shear_simply(PowderLaw const& law, PowderPoint& point, double gamma, int n_steps);

} // namespace continuum
