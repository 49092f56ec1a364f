#pragma once

#include "coupling/diagnosis/error_model.hpp"
#include "coupling/diagnosis/identifiability.hpp"

#include <string>
#include <vector>

namespace coupling::diagnosis {

struct PowerSettings {
  double detection = 5.0;        ///< standard uncertainties out of what calibration absorbs
  double separation = separable; ///< standard uncertainties from the nearest rival
  double most_scales = 10.0;     ///< sizes are looked for up to this many prior scales
  int n_segments = 6;            ///< of a rival's curve, a sign
};

/// What measurements would show of one mechanism. A mechanism with two signs: the harder one.
struct Power {
  std::string name, unit;
  double scale;    ///< of the size's prior [unit]
  double detected; ///< smallest size that is detected [unit]; infinite: none is
  double told;     ///< smallest that is also told from every single rival [unit]; infinite: none is
  std::string rival;     ///< the nearest one there, or at the largest size looked at; empty: none
  double rival_distance; ///< Delta there, standard uncertainties; infinite without a rival
};

/// The power of measurements that are not made yet, one row a mechanism in the model's order. With
///   e_i(a) = P L^-1 (f(a) - f(0)),
/// calibrated parameters at their prior means, P as in signatures.hpp and Sigma = L L' there,
///   detected  the least a with |e_i(a)| = detection,
///   told      the least a >= detected with  min over j, b in [-3 s_j, 3 s_j] of |e_i(a) - e_j(b)|
///             = separation.
/// Changes are taken at the size itself (a tilt shows by its square), not from slopes; only the
/// calibrated parameters' part is linear. A rival's curve e_j(b) is a chain of straight segments,
/// one for its shape parameters at their means and for each of them a standard deviation to either
/// side. Roots to 1e-3 of the size.
/// Source: diagnosis note 2a, 2d; Basseville, Nikiforov (2002) for the projection.
/// @param planned  the rows; their values do not matter
/// @throws dem::InvalidInput as error_model and validate(model) do, or for settings that are not
/// positive
std::vector<Power> power_of(Observations const& planned, Model const& model,
                            ErrorSources const& sources, PowerSettings const& settings = {});

} // namespace coupling::diagnosis
