#pragma once

#include "coupling/diagnosis/unexplained.hpp"

namespace coupling::diagnosis {

/// A form as columns over the rows of one channel, with what it is called.
struct FormColumns {
  FormCandidate form;      ///< amplitude and share not yet known
  Eigen::MatrixXd columns; ///< n_rows x 1, or 2 for a periodic form; 0 outside the channel
};

/// The library of forms in one input: steps and bumps at many places, periods from the whole range
/// to a twelfth of it, linear; none for an input that does not vary in the channel.
/// @param rows  of the channel
std::vector<FormColumns> forms_in(RowInput const& input, std::vector<Eigen::Index> const& rows);

/// Powers 0, 1/2, 2 and 3 of the predicted value, which is the channel's own input.
std::vector<FormColumns> power_forms(Eigen::VectorXd const& predicted,
                                     std::vector<Eigen::Index> const& rows);

/// Columns 1, x, x^2, x^3 of an input over the rows, scaled to -1 .. 1, as many as it has values.
Eigen::MatrixXd polynomial_columns(RowInput const& input, std::vector<Eigen::Index> const& rows);

} // namespace coupling::diagnosis
