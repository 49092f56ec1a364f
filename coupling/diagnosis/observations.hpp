#pragma once

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

/// Diagnosis: where predictions depart from measured data beyond their own error, and which known
/// mechanism explains it. Nothing here knows a simulator, a file or a press.
namespace coupling::diagnosis {

/// The parts of a press cycle. What is measured on the compact afterwards is `after`.
enum class Phase { loading, dwell, unloading, after };

std::string_view name_of(Phase phase);

/// One channel of one run during one phase, in the order of time.
struct ChannelBlock {
  std::string run, channel; ///< e.g. "run1", "upper_punch_force"
  Phase phase = Phase::loading;
  Eigen::VectorXd coordinate{}; ///< how far the phase has gone, 0 to 1, never falling, [n]
  Eigen::VectorXd values{};     ///< measured, [n] [unit of the channel]
  Eigen::VectorXd n_readings{}; ///< readings whose mean each row is, [n]; empty: one each
  int n_repeats = 1;            ///< repeats of the run whose mean `values` is
};

/// Where a block stands among the stacked rows.
struct RowRange {
  Eigen::Index first, n;
};

/// All blocks, stacked in their order.
class Observations {
public:
  /// @throws dem::InvalidInput without a block, for a block that is empty, given twice, holds a
  /// value that is no number, or whose coordinates fall or leave 0 to 1
  explicit Observations(std::vector<ChannelBlock> blocks);

  std::vector<ChannelBlock> const& blocks() const { return blocks_; }
  std::vector<RowRange> const& rows() const { return rows_; } ///< one a block
  Eigen::VectorXd const& values() const { return values_; }   ///< [n_rows]
  Eigen::Index size() const { return values_.size(); }        ///< n_rows

private:
  std::vector<ChannelBlock> blocks_;
  std::vector<RowRange> rows_;
  Eigen::VectorXd values_;
};

/// "run1, upper_punch_force, loading", as refusals and reports name a block.
std::string label_of(ChannelBlock const& block);

} // namespace coupling::diagnosis
