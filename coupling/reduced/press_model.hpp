#pragma once

#include "coupling/reduced/causes.hpp"
#include "coupling/reduced/press_plan.hpp"

namespace coupling::reduced {

/// What the case says of a powder's two calibrated numbers, and how sure it is.
struct Sheet {
  double young_modulus;          ///< E [Pa] of the simulation that the bed's law was fitted to
  double cohesion;               ///< cohesion energy density of that simulation [J/m^3]; 0: none
  double young_modulus_sd = 0.3; ///< of ln E
  double cohesion_sd = 0.5;      ///< of ln CED
};

/// The emulator of a press as a model for the diagnosis: the law of a simulated bed, E and the
/// cohesion energy density calibrated,
///   K = K_0 E / E_0,  S = S_0 E / E_0 + cohesion_slope (CED - CED_0),
/// every known cause a mechanism.
class PressModel final : public diagnosis::Model {
public:
  /// @param nominal  with the numbers of the simulation
  /// @throws dem::InvalidInput for a plan without rows
  PressModel(Press nominal, Sheet const& sheet, RepeatScatter const& scatter, PressPlan plan);

  std::vector<diagnosis::CalibratedParameter> const& calibrated() const override {
    return calibrated_;
  }
  std::vector<diagnosis::Mechanism> const& mechanisms() const override { return mechanisms_; }
  std::vector<diagnosis::Scatter> const& scatters() const override { return scatters_; }
  Eigen::VectorXd predict(diagnosis::Parameters const& at) const override;

  /// The press at a point.
  Press press_at(diagnosis::Parameters const& at) const;
  /// The same model asked for other rows.
  PressModel with_plan(PressPlan plan) const;
  PressPlan const& plan() const { return plan_; }
  RepeatScatter const& scatter() const { return scatter_; }

private:
  Press nominal_;
  Sheet sheet_;
  RepeatScatter scatter_;
  PressPlan plan_;
  std::vector<diagnosis::CalibratedParameter> calibrated_;
  std::vector<diagnosis::Mechanism> mechanisms_;
  std::vector<diagnosis::Scatter> scatters_;
};

/// Rows of a plan by a press.
Eigen::VectorXd predict_plan(Press const& press, PressPlan const& plan);

} // namespace coupling::reduced
