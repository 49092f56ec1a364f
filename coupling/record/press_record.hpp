#pragma once

#include "dem/vec3.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// A named check of the run with its verdict.
struct Check {
  std::string name;
  double value;
  double tolerance;
  bool ok;
};

/// The time series of a run: named columns with units, one row per record, and the stage each row
/// belongs to.
class PressRecord {
public:
  struct Column {
    std::string name; ///< "upper_punch_force"
    std::string unit; ///< "N"
  };

  explicit PressRecord(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// @param values  one per column
  void add_row(std::string stage, std::vector<double> values);

  std::vector<Column> const& columns() const { return columns_; }
  std::vector<std::string> const& stages() const { return stages_; }
  std::vector<std::vector<double>> const& rows() const { return rows_; }
  std::size_t size() const { return rows_.size(); }

  /// All values of one column. @throws std::out_of_range if there is none of that name
  std::vector<double> column(std::string_view name) const;
  bool has(std::string_view name) const;

private:
  std::vector<Column> columns_;
  std::vector<std::string> stages_;
  std::vector<std::vector<double>> rows_;
};

/// What a tool went through. Stresses are NaN for a rigid tool, which knows none.
struct ToolSummary {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::string name;
  double max_von_mises = none;                 ///< [Pa]
  dem::Vec3 where = dem::Vec3::Constant(none); ///< [m], of that stress
  double valid_below_depth = none; ///< [m], stresses nearer to the surface are not resolved
  double yield_utilisation = none; ///< [1], largest stress / yield stress
  double contact_share = none;     ///< [1], see tool_share()
};

/// Single numbers of a run: what summary.json holds. A value that the run did not reach (no release
/// yet) is NaN and written as null.
struct Summary {
  double max_force = 0.0;                                           ///< [N]
  double ejection_force = std::numeric_limits<double>::quiet_NaN(); ///< [N], of stages until flush
  double porosity = 0.0;                                            ///< [1], the seed's
  double porosity_core = 0.0;                                       ///< [1]
  double compact_height = 0.0;   ///< [m], where the porosity was taken
  double springback = 0.0;       ///< [1], (compact height - smallest gap) / smallest gap
  int shape_quality = 0;         ///< 1 to 5; 0 = not reached
  double shape_similarity = 0.0; ///< [1]
  std::uint64_t grains = 0;
  std::uint64_t steps = 0;
  double time_step = 0.0; ///< [s], smallest used
  double wall_seconds = 0.0;
  double particle_steps_per_second = 0.0;
  std::string mode = "rigid";
  std::string version;
  std::vector<Check> checks;
  std::vector<ToolSummary> tools;
};

} // namespace coupling
