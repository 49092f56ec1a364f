#pragma once

#include <vector>

namespace coupling::diagnosis {

/// What a statistic is when nothing is wrong, by draws. Large values speak against.
class Reference {
public:
  /// @throws dem::InvalidInput for fewer than 2 draws
  explicit Reference(std::vector<double> draws);

  /// (1 + number of draws >= value) / (1 + n_draws): a valid p-value at any number of draws.
  double p(double value) const;

  /// The same while at least ten draws lie beyond; further out the tail of the scaled chi^2 with
  /// the draws' mean and variance, never above p(). For maps, where Holm's factor would
  /// otherwise hide what is far beyond all draws.
  double tail_p(double value) const;

  double mean() const { return mean_; }
  double sd() const { return sd_; }
  int n_draws() const { return static_cast<int>(draws_.size()); }

private:
  std::vector<double> draws_; ///< ascending
  double mean_, sd_;
};

} // namespace coupling::diagnosis
