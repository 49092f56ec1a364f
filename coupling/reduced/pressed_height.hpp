#pragma once

#include "coupling/diagnosis/error_terms.hpp"
#include "coupling/diagnosis/model.hpp"
#include "coupling/diagnosis/observations.hpp"
#include "coupling/measured/measured_data.hpp"
#include "coupling/reduced/causes.hpp"

#include <string>
#include <vector>

namespace coupling::reduced {

/// How much a compact of pressed oxide powder grows when it is set free, relative to its height in
/// the die, normal and not negative: in-die recovery of 65 MPa over a green modulus of 2 to 8 GPa
/// is 0.7 to 3 %, reported values lie between 0.3 and 3 %. Source: powder note, 5.3.
struct Springback {
  double mean = 0.02, sd = 0.01;
  double radial_share = 0.15; ///< growth of the diameter over that of the height
};

/// sd of a grain density that nobody stated, over that of the case: tables and pycnometers differ
/// by that much for calcined oxides.
inline constexpr double solid_density_share = 0.03;

/// What is asked of a pressing.
enum class Asked {
  compact_height,  ///< [m]
  porosity,        ///< [1], mass over density against outer dimensions
  height_less_gap, ///< [m], of the compact, less what the machine took the gap to be
  gap_at_peak,     ///< [m], between the faces at the largest force
  blank_travel,    ///< [m], of the machine, punch on punch, from first touch to the force
  blank_zero,      ///< [m], that the machine shows where the punches touch
  opening_travel   ///< [m], of the machine from the largest force to none
};

/// One number of one pressing, and what the laboratory knows of that pressing.
struct HeightRow {
  Asked asked;
  double gap;   ///< [m], that the machine took the punches to be apart at the end
  double force; ///< [N], largest
  double time;  ///< [s], from the start to the end of the closing
};

/// Whether the numbers of a pressing fit each other, with no powder's law: one force at one gap is
/// spent on the modulus of the grains, and what is left is geometry. With the punches' faces at
///   h = gap + z_0 + drift + D(F),
/// the compact is H = h (1 + s) high and P = 1 - m / (rho A H) porous, A that of the bore grown by
/// radial_share s. Calibrated: springback s and, for porosities, the grains' density rho.
/// Mechanisms: those of known_causes() that act on gap, mass and die.
class PressedHeight final : public diagnosis::Model {
public:
  struct Known {
    Press nominal;                     ///< machine, and the bed that holds the mass
    measured::Uncertain solid_density; ///< [kg/m^3], with which porosities were computed
    double gap_sd;                     ///< [m], of a gap
    double mass_sd;                    ///< [1], relative
    /// [m], from fill height to end gap: where nobody read the gap, its zero may be wrong by
    /// limits::end_gap_share of that.
    double stroke;
    bool gap_is_of_faces = false;
    Springback springback = {};
  };
  /// @throws dem::InvalidInput without rows
  PressedHeight(Known known, std::vector<HeightRow> rows);

  std::vector<diagnosis::CalibratedParameter> const& calibrated() const override {
    return calibrated_;
  }
  std::vector<diagnosis::Mechanism> const& mechanisms() const override { return mechanisms_; }
  std::vector<diagnosis::Scatter> const& scatters() const override { return scatters_; }
  Eigen::VectorXd predict(diagnosis::Parameters const& at) const override;

  /// The same pressing asked for other numbers, with the same parameters.
  PressedHeight with_rows(std::vector<HeightRow> rows) const;
  std::vector<HeightRow> const& rows() const { return rows_; }
  Known const& known() const { return known_; }

private:
  Press press_at(diagnosis::Parameters const& at) const;

  Known known_;
  std::vector<HeightRow> rows_;
  std::vector<Cause> causes_;
  std::vector<diagnosis::CalibratedParameter> calibrated_;
  std::vector<diagnosis::Mechanism> mechanisms_;
  std::vector<diagnosis::Scatter> scatters_;
};

/// Numbers of the fitted runs that have no curve, as rows and blocks in the same order.
struct HeightRows {
  std::vector<HeightRow> rows;
  std::vector<diagnosis::ChannelBlock> blocks;
  std::vector<diagnosis::ChannelError> channels;
  std::vector<std::string> left_out; ///< in words
};
HeightRows height_rows(measured::MeasuredData const& data);

} // namespace coupling::reduced
