#include "coupling/press_servo.hpp"

#include "dem/expect.hpp"

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

// A secant over a thousandth of the gap is long against the force's ripple and short against the
// curve's bend.
constexpr double secant_fraction = 1e-3;

} // namespace

void ForceServo::watch(double gap, double force) {
  double const closed = reference_gap_ - gap;
  if (reference_gap_ > 0.0 && std::abs(closed) < secant_fraction * gap)
    return;
  double const secant = (force - reference_force_) / closed;
  if (reference_gap_ > 0.0 && closed > 0.0 && secant > 0.0)
    stiffness_ = secant;
  reference_gap_ = gap;
  reference_force_ = force;
}

void ForceServo::start(double fallback_stiffness) {
  EXPECT(fallback_stiffness > 0.0);
  integral_ = 0.0;
  if (stiffness_ == 0.0)
    stiffness_ = fallback_stiffness;
}

double ForceServo::closing_speed(ServoReading const& now, double wanted_force, double fastest,
                                 double dt) {
  EXPECT(stiffness_ > 0.0 && fastest > 0.0);
  double const missing = wanted_force - now.force;
  double const response_time = 4.0 * std::sqrt(now.mass / stiffness_);
  double const wanted = (missing + integral_) / (stiffness_ * response_time);
  double const speed = std::clamp(wanted, -fastest, fastest);
  // At the speed limit the integral stands still, or it would overshoot by what it collected there.
  if (speed == wanted)
    integral_ += missing * dt / (4.0 * response_time);
  return speed;
}

} // namespace coupling
