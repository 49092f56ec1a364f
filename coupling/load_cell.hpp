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

  /// After every step of dt [s]: the force [N] is taken as constant in it.
  void step_done(double force, double dt) {
    time_ += dt;
    felt_ += errors_.lag > 0.0 ? -std::expm1(-dt / errors_.lag) * (force - felt_) : force - felt_;
  }

  double reading() const { return errors_.gain * felt_ + errors_.offset + errors_.drift * time_; }

  template <class Field> void visit_state(Field&& field) {
    field("load_cell/felt", felt_);
    field("load_cell/time", time_);
  }

private:
  LoadCellErrors errors_;
  double felt_ = 0.0; // [N], y
  double time_ = 0.0; // [s]
};

} // namespace coupling
