#include "coupling/diagnosis/differences.hpp"

#include <algorithm>

namespace coupling::diagnosis {

Eigen::VectorXd size_signature(Model const& model, Parameters const& at, int mechanism,
                               Eigen::Index n_rows) {
  auto const& one = model.mechanisms()[static_cast<std::size_t>(mechanism)];
  double const step = signature_step * one.scale;
  double const lowest = one.is_one_sided ? std::max(0.0, one.low) : one.low;
  double const size = at.sizes[mechanism];
  Parameters more = at, less = at;
  more.sizes[mechanism] = std::min(size + step, one.high);
  less.sizes[mechanism] = std::max(size - step, lowest);
  return (predict_rows(model, more, n_rows) - predict_rows(model, less, n_rows)) /
         (more.sizes[mechanism] - less.sizes[mechanism]);
}

Eigen::MatrixXd scatter_changes(Model const& model, Parameters const& at, Eigen::Index n_rows) {
  auto const n = static_cast<Eigen::Index>(model.scatters().size());
  Eigen::MatrixXd changes(n_rows, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    Parameters more = at, less = at;
    more.scatter[k] += model.scatters()[static_cast<std::size_t>(k)].sd;
    less.scatter[k] -= model.scatters()[static_cast<std::size_t>(k)].sd;
    changes.col(k) = 0.5 * (predict_rows(model, more, n_rows) - predict_rows(model, less, n_rows));
  }
  return changes;
}

Eigen::VectorXd change_by(Model const& model, Parameters const& at, int mechanism,
                          Eigen::Index n_rows) {
  Parameters without = at;
  without.sizes[mechanism] = 0.0;
  return predict_rows(model, at, n_rows) - predict_rows(model, without, n_rows);
}

} // namespace coupling::diagnosis
