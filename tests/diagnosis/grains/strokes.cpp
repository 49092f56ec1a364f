#include "tests/diagnosis/grains/strokes.hpp"

#include <algorithm>

namespace hidden {

Eigen::VectorXd at_gaps(std::vector<Moment> const& stroke, double Moment::*reading,
                        std::vector<double> const& gaps) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(gaps.size()));
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    // By falling gap.
    auto const after =
        std::ranges::lower_bound(stroke, -gaps[k], {}, [](auto& at) { return -at.gap; });
    auto const next = std::clamp(after, stroke.begin() + 1, stroke.end() - 1), before = next - 1;
    double const share =
        std::clamp((before->gap - gaps[k]) / std::max(before->gap - next->gap, 1e-12), 0.0, 1.0);
    values[static_cast<Eigen::Index>(k)] =
        (*before).*reading + share * ((*next).*reading - (*before).*reading);
  }
  return values;
}

std::vector<double> gaps_of(std::vector<Pressed> const& stroke, double peak, int n) {
  double widest = 0.0, least = stroke.front().height;
  for (auto const& at : stroke) {
    least = std::min(least, at.height);
    if (at.upper > 0.01 * peak)
      widest = std::max(widest, at.height);
  }
  std::vector<double> gaps;
  for (int k = 0; k < n; ++k)
    gaps.push_back(least + (widest - least) * (k + 0.5) / n);
  return gaps;
}

Curve turned_at(Curve const& curve, double gap) {
  Curve early = curve;
  while (early.loading.back().height < gap)
    early.loading.pop_back();
  auto const &turn = early.loading.back(), &was = curve.loading.back();
  for (auto& at : early.unloading) {
    at.height *= turn.height / was.height;
    at.upper *= turn.upper / was.upper;
    at.lower *= turn.lower / was.lower;
    at.radial *= turn.radial / was.radial;
  }
  return early;
}

Curve with_mass(Curve curve, double share) {
  for (auto* stroke : {&curve.loading, &curve.unloading})
    for (auto& at : *stroke)
      at.height *= 1.0 + share;
  return curve;
}

Curve with_bore(Curve curve, double share) {
  double const area = (1.0 + share) * (1.0 + share);
  for (auto* stroke : {&curve.loading, &curve.unloading})
    for (auto& at : *stroke)
      at.height /= area, at.upper *= area, at.lower *= area;
  return curve;
}

} // namespace hidden
