#include "coupling/press_frame.hpp"

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

/// d with  d = D(force - stiffness (d - reference)),  by Newton's method: D is increasing and
/// concave, so from the reference the iteration does not leave the root's neighbourhood.
double meet_bed(FrameLaw const& law, double force, double stiffness, double reference) {
  double d = reference;
  for (int k = 0; k < 8; ++k) {
    double const carried = std::max(force - stiffness * (d - reference), 0.0);
    d += (law.deflection(carried) - d) / (1.0 + stiffness * law.compliance(carried));
  }
  return d;
}

} // namespace

double FrameLaw::deflection(double force) const {
  if (is_rigid())
    return 0.0;
  double const seated = seating > 0.0 ? -seating * std::expm1(-force / seating_force) : 0.0;
  return force / stiffness + seated;
}

double FrameLaw::compliance(double force) const {
  if (is_rigid())
    return 0.0;
  double const seats =
      seating > 0.0 ? seating / seating_force * std::exp(-force / seating_force) : 0.0;
  return 1.0 / stiffness + seats;
}

double FrameLaw::energy(double force) const {
  if (is_rigid())
    return 0.0;
  double const ratio = seating > 0.0 ? force / seating_force : 0.0;
  double const seats = seating * seating_force * (1.0 - (1.0 + ratio) * std::exp(-ratio));
  return 0.5 * force * force / stiffness + seats;
}

void PressFrame::step_done(double force, double gap, double dt) {
  clock_ += dt;
  if (law_.is_rigid())
    return;
  deflection_ += dt * speed_;
  impulse_ += dt * force;
  gap_integral_ += dt * gap;
  deflection_integral_ += dt * deflection_;
  time_ += dt;
  if (++steps_ == window)
    end_window();
}

void PressFrame::end_window() {
  double const force = std::max(impulse_ / time_, 0.0), gap = gap_integral_ / time_;
  largest_deflection_ = std::max(largest_deflection_, std::abs(deflection_));
  largest_departure_ =
      std::max(largest_departure_, std::abs(deflection_integral_ / time_ - law_.deflection(force)));
  double ahead = force;
  if (windows_ > 0) {
    // From the middle of this window to the end of the next one.
    ahead = std::max(force + 1.5 * (force - last_force_), 0.0);
    double const stiffness = (force - last_force_) / (last_gap_ - gap);
    if (std::isfinite(stiffness) && stiffness > 0.0)
      bed_stiffness_ = stiffness;
  }
  double const wanted = meet_bed(law_, ahead, bed_stiffness_, deflection_ + time_ * speed_);
  speed_ = (wanted - deflection_) / time_;
  last_force_ = force;
  last_gap_ = gap;
  ++windows_;
  steps_ = 0;
  impulse_ = gap_integral_ = deflection_integral_ = time_ = 0.0;
}

double PressFrame::largest_error() const {
  return largest_deflection_ > 0.0 ? largest_departure_ / largest_deflection_ : 0.0;
}

} // namespace coupling
