#pragma once

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

namespace coupling::diagnosis {

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// A parameter that is legitimately calibrated, with what the material sheet says of it.
struct CalibratedParameter {
  std::string name, unit; ///< e.g. "young_modulus", "Pa"
  double mean;            ///< of the prior; its median if logarithmic
  double sd;              ///< of the prior, > 0 [unit], or of ln(value) if logarithmic
  double low = -no_bound, high = no_bound;
  bool is_logarithmic = false;
};

/// A parameter of a mechanism's law, with a normal prior; without meaning while its size is 0.
struct ShapeParameter {
  std::string name, unit;
  double mean, sd;
  double low = -no_bound, high = no_bound;
};

enum class SizeTail {
  normal, ///< sizes beyond 2 scales are surprising
  student ///< Student's t with 4 degrees of freedom: they are possible
};

/// A candidate cause: a real term of the simulator, off at size 0.
struct Mechanism {
  std::string name, unit;
  double scale; ///< of the size's prior, > 0: the largest that a competent laboratory would meet
  SizeTail tail = SizeTail::normal;
  bool is_one_sided = false; ///< the size cannot be negative
  double low = -no_bound, high = no_bound;
  std::vector<ShapeParameter> shapes{};
};

/// What scatters from repeat to repeat: mass, fill, packing, zero, wall friction.
struct Scatter {
  std::string name, unit;
  double sd; ///< of a single run, > 0
};

/// A point at which a model is asked.
struct Parameters {
  Eigen::VectorXd calibrated;          ///< [n_calibrated]
  Eigen::VectorXd sizes;               ///< [n_mechanisms], 0 = off
  std::vector<Eigen::VectorXd> shapes; ///< one vector a mechanism
  Eigen::VectorXd scatter;             ///< [n_scatters], departures from the nominal run
};

/// A simulator, or an emulator of it, that predicts the stacked rows of one set of observations.
class Model {
public:
  virtual ~Model() = default;
  virtual std::vector<CalibratedParameter> const& calibrated() const = 0;
  virtual std::vector<Mechanism> const& mechanisms() const = 0;
  virtual std::vector<Scatter> const& scatters() const = 0;

  /// The rows at a point, [n_rows]. The same point gives the same bits.
  virtual Eigen::VectorXd predict(Parameters const& at) const = 0;

  /// R with R R' = covariance of the mechanism's signature d f / d size, n_rows x k; without
  /// columns where it is exact.
  virtual Eigen::MatrixXd signature_error(int mechanism) const;
};

/// Prior means, all mechanisms off, no scatter.
Parameters nominal_parameters(Model const& model);

/// Refuses a model whose priors cannot be used.
/// @throws dem::InvalidInput for a scale or sd that is not positive, bounds that exclude the prior
/// mean or size 0, a name given twice, a logarithmic parameter that is not positive
void validate(Model const& model);

/// Predictions with a check of their number.
/// @throws dem::InvalidInput unless there are `n_rows`, all finite
Eigen::VectorXd predict_rows(Model const& model, Parameters const& at, Eigen::Index n_rows);

} // namespace coupling::diagnosis
