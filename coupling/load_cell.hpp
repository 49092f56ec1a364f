#pragma once

#include <cmath>

namespace coupling {

/// What a load cell shows of the force on it:
///   F_m(t) = g y(t) + o + d t,   y' = (F - y) / tau
/// A cell of gain 1 and nothing else shows the force.
struct LoadCellErrors {
  double gain = 1.0;   ///< g [1]
  double offset = 0.0; ///< o [N]
  double drift = 0.0;  ///< d [N/s]
  double lag = 0.0;    ///< tau [s]
};

/// A load cell on the upper punch.
class LoadCell {
public:
  explicit LoadCell(LoadCellErrors errors = {}) : errors_(errors) {}

  /// After every step of dt [s], at whose end the force is `force` [N]; exact for a force that went
  /// there on a straight line from the last one:
  ///   y_1 = F_1 - c tau + (y_0 - F_0 + c tau) exp(-dt / tau),  c = (F_1 - F_0) / dt
  void step_done(double force, double dt) {
    time_ += dt;
    if (errors_.lag > 0.0 && dt > 0.0) {
      double const behind = (force - force_) / dt * errors_.lag;
      felt_ = force - behind + (felt_ - force_ + behind) * std::exp(-dt / errors_.lag);
    } else {
      felt_ = force;
    }
    force_ = force;
  }

  double reading() const { return errors_.gain * felt_ + errors_.offset + errors_.drift * time_; }

  template <class Field> void visit_state(Field&& field) {
    field("load_cell/force", force_);
    field("load_cell/felt", felt_);
    field("load_cell/time", time_);
  }

private:
  LoadCellErrors errors_;
  double force_ = 0.0; // [N], at the last step
  double felt_ = 0.0;  // [N], y
  double time_ = 0.0;  // [s]
};

} // namespace coupling
