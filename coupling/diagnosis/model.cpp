#include "coupling/diagnosis/model.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace coupling::diagnosis {
namespace {

void validate_prior(std::string const& name, double mean, double sd, double low, double high) {
  VALIDATE(sd > 0.0 && std::isfinite(sd) && std::isfinite(mean),
           fmt::format("{}: has the prior {:g}, sd {:g} (an sd is positive). What does the "
                       "material sheet say?",
                       name, mean, sd));
  VALIDATE(low <= mean && mean <= high && low < high,
           fmt::format("{}: may go from {:g} to {:g} (its usual value {:g} must lie between). Are "
                       "the bounds in the same unit?",
                       name, low, high, mean));
}

} // namespace

Eigen::MatrixXd Model::signature_error(int /*mechanism*/) const {
  return {};
}

Parameters nominal_parameters(Model const& model) {
  Parameters at;
  at.calibrated.resize(static_cast<Eigen::Index>(model.calibrated().size()));
  for (Eigen::Index p = 0; p < at.calibrated.size(); ++p)
    at.calibrated[p] = model.calibrated()[static_cast<std::size_t>(p)].mean;
  at.sizes = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.mechanisms().size()));
  for (auto const& mechanism : model.mechanisms()) {
    Eigen::VectorXd shapes(static_cast<Eigen::Index>(mechanism.shapes.size()));
    for (Eigen::Index k = 0; k < shapes.size(); ++k)
      shapes[k] = mechanism.shapes[static_cast<std::size_t>(k)].mean;
    at.shapes.push_back(shapes);
  }
  at.scatter = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.scatters().size()));
  return at;
}

void validate(Model const& model) {
  std::set<std::string> names;
  auto const expect_new = [&](std::string const& name) {
    VALIDATE(names.insert(name).second,
             fmt::format("{}: is the name of two unknowns. Which is meant?", name));
  };
  for (auto const& one : model.calibrated()) {
    expect_new(one.name);
    validate_prior(one.name, one.mean, one.sd, one.low, one.high);
    VALIDATE(!one.is_logarithmic || one.mean > 0.0,
             fmt::format("{}: is logarithmic with mean {:g} (it must be positive). Is the scale "
                         "meant to be linear?",
                         one.name, one.mean));
  }
  names.clear(); // a sheet that is wrong is a mechanism of its parameter's name
  for (auto const& one : model.mechanisms()) {
    expect_new(one.name);
    validate_prior(one.name, 0.0, one.scale, one.low, one.high);
    for (auto const& shape : one.shapes)
      validate_prior(fmt::format("{}/{}", one.name, shape.name), shape.mean, shape.sd, shape.low,
                     shape.high);
  }
  for (auto const& one : model.scatters())
    VALIDATE(one.sd >= 0.0 && std::isfinite(one.sd),
             fmt::format("{}: scatters by {:g} {} (0 or more). Was a variance meant?", one.name,
                         one.sd, one.unit));
}

Eigen::VectorXd predict_rows(Model const& model, Parameters const& at, Eigen::Index n_rows) {
  Eigen::VectorXd f = model.predict(at);
  VALIDATE(f.size() == n_rows,
           fmt::format("model: predicts {} rows where {} were measured (they stand side by side). "
                       "Does it know the same blocks?",
                       f.size(), n_rows));
  VALIDATE(f.allFinite(), "model: predicts a value that is no number. Do its bounds keep it where "
                          "it holds?");
  return f;
}

} // namespace coupling::diagnosis
