#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <variant>

namespace continuum {

/// What a law remembers of a point beside its elastic strain, which the caller keeps (as b_e).
struct PowderState {
  double plastic_compaction = 0.0; ///< eps_v^p = ln(D / D0) [-], compaction positive
};

/// Where the stress of a step ended.
enum class PowderSurface {
  none,       ///< inside: the step was elastic
  ellipse,    ///< modified Cam-Clay
  cap,        ///< elliptic cap, p >= p_a
  transition, ///< arc between shear line and cap
  shear,      ///< Drucker-Prager line
  tension,    ///< cut-off of the mean stress
  edge        ///< where shear line and cut-off meet: the apex, if the cut-off is there
};
std::string name_of(PowderSurface surface);

/// End of one step, in principal axes, which are those of the trial strain. Tension positive.
struct PowderResponse {
  Eigen::Vector3d elastic_strain; ///< logarithmic [-]
  Eigen::Vector3d stress;         ///< Cauchy [Pa]
  Eigen::Matrix3d tangent;        ///< d stress / d trial strain [Pa], exact for the discrete step,
                                  ///< unsymmetric in general
  PowderState state;
  PowderSurface surface = PowderSurface::none;
  double plastic_work = 0.0; ///< sigma : d eps^p of the step [J/m^3 of present volume]
};

/// Why a step has no answer. The caller cuts its step; there is never a stress beside this.
struct PowderFailure {
  enum class Reason {
    no_convergence,    ///< no surface gave an admissible end
    density_above_one, ///< the step would compact beyond the solid
    inverted           ///< det F <= 0: the step turns the body inside out
  };
  Reason reason;
  int n_iterations;        ///< of all attempts
  double least_residual;   ///< smallest that was reached [-], in strains
  double relative_density; ///< D at the step's beginning
  std::string message() const;
};

/// What was asked for, or the reason why there is none.
template <class T> class OrFailure {
public:
  // Either is returned as it is.
  // NOLINTNEXTLINE(google-explicit-constructor)
  OrFailure(T const& value) : content_(value) {}
  // NOLINTNEXTLINE(google-explicit-constructor)
  OrFailure(PowderFailure const& failure) : content_(failure) {}

  explicit operator bool() const { return std::holds_alternative<T>(content_); }
  T const& operator*() const { return std::get<T>(content_); }
  T const* operator->() const { return &**this; }
  PowderFailure const& failure() const { return std::get<PowderFailure>(content_); }

private:
  std::variant<T, PowderFailure> content_;
};
using PowderResult = OrFailure<PowderResponse>;

/// Mean stress and von Mises stress [Pa], p positive in compression:
///     p = -tr(sigma)/3,   q = sqrt(3/2) |dev sigma|.
struct Invariants {
  double p, q;
};
Invariants invariants(Eigen::Vector3d const& principal_stress);

} // namespace continuum
