#pragma once

namespace coupling {

/// What the servo needs to know of the press at one moment.
struct ServoReading {
  double gap;   ///< [m], between the punch faces
  double force; ///< [N], squeezing the driven tool
  double mass;  ///< [kg], of the grains
};

/// Keeps a force on a tool by moving it: a PI controller scaled by the bed's own stiffness and
/// inertia.
///   u = (e + I) / (k tau),   dI/dt = e / (4 tau),   tau = 4 sqrt(m / k)
/// with e the force missing [N], u the closing speed [m/s], k the bed's stiffness [N/m]. With dF/dt
/// = k u the error follows (s + 1/(2 tau))^2 = 0: critically damped, and a creeping bed leaves no
/// offset. sqrt(m/k) is the time that a wave needs through the bed; four of them keep the
/// controller slower than the bed answers. k is the secant of force over gap as long as the bed is
/// being pressed; before that, the caller's estimate.
class ForceServo {
public:
  /// Follows the secant stiffness while the punches close. Call after every step of a motion.
  /// @param gap  [m], @param force  [N]
  void watch(double gap, double force);

  /// Prepares a hold. @param fallback_stiffness  [N/m], used if no motion has shown the bed's
  void start(double fallback_stiffness);

  /// @param fastest  bound of the closing speed [m/s]
  /// @returns        closing speed for the next step [m/s], negative opens
  double closing_speed(ServoReading const& now, double wanted_force, double fastest, double dt);

  double stiffness() const { return stiffness_; }

  template <class Field> void visit_state(Field&& field) {
    field("servo/integral", integral_);
    field("servo/stiffness", stiffness_);
    field("servo/reference_gap", reference_gap_);
    field("servo/reference_force", reference_force_);
  }

private:
  double integral_ = 0.0;        // [N]
  double stiffness_ = 0.0;       // [N/m]; 0 = not seen yet
  double reference_gap_ = 0.0;   // [m]; 0 = none
  double reference_force_ = 0.0; // [N]
};

} // namespace coupling
