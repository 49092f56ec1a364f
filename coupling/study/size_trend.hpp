#pragma once

#include "coupling/study/packing_model.hpp"

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

/// A response against a size, carried on to a size that was not run.
namespace coupling::study {

/// A curve y(D; p). `low` and `high` bound the parameters of a form that is not linear in them.
struct TrendForm {
  std::string name;
  std::vector<std::string> parameters;
  std::function<double(Eigen::VectorXd const& parameters, double size)> value;
  bool is_linear; ///< in the parameters
  Eigen::VectorXd low, high;
  bool needs_positive = false; ///< responses
};

TrendForm linear_form();      ///< a + b D: the seed's
TrendForm quadratic_form();   ///< a + b D + c D^2
TrendForm logarithmic_form(); ///< a + b ln(D / m)

/// a D^b, by least squares in y.
/// @param sizes, responses  > 0; they bound the search
TrendForm power_form(std::vector<double> const& sizes, std::vector<double> const& responses);

/// Porosity [1] of fines of size D between coarse grains by de Larrard's model (packing_model.hpp);
/// free are the virtual packing of all grains and one coarse size.
/// @param largest_size  [m], of the fines that were run
TrendForm packing_form(double fine_share, double compaction_index, double largest_size);
/// The same with known coarse classes (sizes [m], shares of the coarse volume; their packing is not
/// read); free is the virtual packing alone.
TrendForm packing_form(std::vector<GrainClass> coarse, double fine_share, double compaction_index);

struct TrendFit {
  std::string form;
  std::vector<std::string> names; ///< of the parameters
  Eigen::VectorXd parameters;
  double residual_ss;
  int df;      ///< sizes - parameters
  double aicc; ///< n ln(RSS / n) + 2 k + 2 k (k + 1) / (n - k - 1), k = parameters + 1; NaN where n
               ///< <= k + 1 or RSS = 0. Hurvich, Tsai, Biometrika 76 (1989) 297
  double value;        ///< at the size asked for
  double lower, upper; ///< 95 % prediction interval of a run there, if the form were true; NaN
                       ///< where df is 0. For forms that are not linear: linearised.
  double lever; ///< sqrt(1 + g^T (J^T J)^-1 g), g = dy/dp: the prediction's sd in residual sds
};

/// No form is known to be true, and the points seldom decide: the spread of the values is the
/// uncertainty that comes from the choice. It comes on top of the intervals.
struct Extrapolation {
  double size;
  std::vector<TrendFit> fits;
  double lowest, highest;            ///< of the values of the fits
  std::vector<std::string> left_out; ///< forms that could not be fitted and why
  std::vector<std::string> statements;
};

/// @param sizes      D, one a run, > 0
/// @param responses  one a run
/// @param size       where, > 0
/// @throws dem::InvalidInput for tables that differ in length, values that are no numbers, sizes
/// that are not above 0, fewer than two different sizes, or no form that can be fitted
Extrapolation extrapolate(std::vector<double> const& sizes, std::vector<double> const& responses,
                          double size, std::vector<TrendForm> const& forms);

} // namespace coupling::study
