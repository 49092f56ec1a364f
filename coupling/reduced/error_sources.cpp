#include "coupling/reduced/error_sources.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::reduced {
namespace {

using diagnosis::ChannelError;
using Eigen::Index;
using Eigen::MatrixXd;

/// Radial pressure of a bed of grains scatters along the wall; the ejection of a compact hangs on a
/// friction at rest that no press run tells.
constexpr double radial_share = 0.005, ejection_share = 0.15;

/// Share of the prediction that the simulator and its emulator may be wrong by.
double share_of(std::string const& channel, BedFit const& fit, double declared) {
  auto const with = [&](Departure const& a, Departure const& b) {
    return std::hypot(declared, std::max(a.rms, b.rms));
  };
  if (channel == "upper_punch_force" || channel == "max_force")
    return with(fit.loading_upper, fit.unloading_upper);
  if (channel == "lower_punch_force")
    return with(fit.loading_lower, fit.unloading_lower);
  if (channel == "wall_radial_pressure")
    return std::hypot(declared, radial_share);
  if (channel == "ejection_force")
    return ejection_share;
  return channel == "compact_mass" || channel == "compact_diameter" ? 0.0 : declared;
}

} // namespace

MatrixXd numerical_covariance(PressModel const& model, BedUncertainty const& uncertainty) {
  auto const nominal = model.press_at(nominal_parameters(model));
  auto const at_nominal = predict_plan(nominal, model.plan());
  MatrixXd changes(at_nominal.size(), 4);
  Index column = 0;
  auto const vary = [&](auto change) {
    Press press = nominal;
    change(press.pressed.law);
    changes.col(column++) = predict_plan(press, model.plan()) - at_nominal;
  };
  vary([&](BedLaw& law) { law.onset += uncertainty.onset; });
  vary([&](BedLaw& law) { law.recovery *= 1.0 - uncertainty.recovery; });
  vary([&](BedLaw& law) { law.wall_friction *= 1.0 + uncertainty.wall_friction; });
  vary([&](BedLaw& law) { law.radial_ratio *= 1.0 + uncertainty.radial_ratio; });
  return changes * changes.transpose();
}

diagnosis::ErrorSources error_sources(PressModel const& model, std::vector<ChannelError> channels,
                                      BedFit const& fit, BedUncertainty const& uncertainty) {
  diagnosis::ErrorSources sources{.channels = std::move(channels)};
  for (auto& channel : sources.channels)
    if (!channel.model_share)
      channel.model_share = share_of(channel.channel, fit, sources.tolerances.model_share);
  sources.numerical.covariance = numerical_covariance(model, uncertainty);
  return sources;
}

} // namespace coupling::reduced
