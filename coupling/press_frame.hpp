#pragma once

#include <cstdint>

namespace coupling {

/// How far the machine gives under the force that it carries [m]:
///   D(F) = F/K + s (1 - exp(-F/F_s)),  F >= 0
/// a spring, and joints that seat themselves under the first load. Its zero may be wrong, too.
struct FrameLaw {
  double stiffness = 0.0;     ///< K [N/m]; 0: rigid, and nothing below counts
  double seating = 0.0;       ///< s [m], that the joints give in all
  double seating_force = 0.0; ///< F_s [N], scale on which they do
  /// How far off the machine's idea of the gap is at no force: z_0 [m] + e [m/s] t.
  double gap_offset = 0.0, thermal_drift = 0.0;

  bool measures_the_gap() const { return gap_offset == 0.0 && thermal_drift == 0.0; }
  bool is_rigid() const { return stiffness == 0.0; }
  double deflection(double force) const;
  double compliance(double force) const; ///< dD/dF [m/N]
  /// Work stored and lost in it,  int F dD [J].
  double energy(double force) const;
};

/// The press frame as a spring in series with the upper punch: the punch stands D(F) further out
/// than the machine commands. Quasi-static, in windows of a few steps: the window's mean force and
/// gap give force and stiffness k of the bed; the deflection at the end of the next window solves
///   d = D(F - k (d - d0)),
/// with F extrapolated to that moment for a punch that went on as it does, d0; so it stays stable
/// however soft the frame is against the bed, where d = D(F) diverges from k dD/dF = 1 on. The
/// punch gets there on a ramp.
class PressFrame {
public:
  static constexpr std::uint64_t window = 20; ///< steps

  explicit PressFrame(FrameLaw law = {}) : law_(law) {}

  FrameLaw const& law() const { return law_; }
  /// [m], opens the gap beyond what the machine takes it to be; error of its zero included.
  double deflection() const { return deflection_ + law_.gap_offset + law_.thermal_drift * clock_; }
  double speed() const { return speed_ + law_.thermal_drift; } ///< [m/s], of deflection()

  /// After every step.
  /// @param force  that squeezes the upper punch [N]
  /// @param gap    between the punch faces as they are [m]
  /// @param dt     [s]
  void step_done(double force, double gap, double dt);

  /// Largest |d - D(F)| over the windows, over the largest deflection [1].
  double largest_error() const;

  template <class Field> void visit_state(Field&& field) {
    field("frame/clock", clock_);
    field("frame/deflection", deflection_);
    field("frame/speed", speed_);
    field("frame/steps", steps_);
    field("frame/impulse", impulse_);
    field("frame/gap_integral", gap_integral_);
    field("frame/time", time_);
    field("frame/deflection_integral", deflection_integral_);
    field("frame/last_force", last_force_);
    field("frame/last_gap", last_gap_);
    field("frame/windows", windows_);
    field("frame/bed_stiffness", bed_stiffness_);
    field("frame/largest_deflection", largest_deflection_);
    field("frame/largest_departure", largest_departure_);
  }

private:
  void end_window();

  FrameLaw law_;
  double clock_ = 0.0;      // [s], since the start
  double deflection_ = 0.0; // [m], of the spring
  double speed_ = 0.0;      // [m/s], of its ramp

  // The present window.
  std::uint64_t steps_ = 0;
  double impulse_ = 0.0;             // [N s]
  double gap_integral_ = 0.0;        // [m s]
  double deflection_integral_ = 0.0; // [m s]
  double time_ = 0.0;                // [s]

  // The window before it.
  double last_force_ = 0.0; // [N], mean
  double last_gap_ = 0.0;   // [m], mean
  std::uint64_t windows_ = 0;

  double bed_stiffness_ = 0.0;                                // [N/m]
  double largest_deflection_ = 0.0, largest_departure_ = 0.0; // [m]
};

} // namespace coupling
