#include "tests/crosscode/liggghts/curve.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace crosscode {
Curve read_peer_curve(std::filesystem::path const& file) {
  std::ifstream in(file);
  Curve curve;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    CurvePoint p{};
    if (words >> p.time >> p.gap >> p.upper_force >> p.lower_force)
      curve.push_back(p);
  }
  if (curve.empty())
    throw std::runtime_error(file.string() + ": no force recorded (the peer did not run)");
  return curve;
}

Curve curve_of(coupling::PressRecord const& record) {
  auto const time = record.column("time"), gap = record.column("punch_gap");
  auto const upper = record.column("upper_punch_force"), lower = record.column("lower_punch_force");
  Curve curve;
  for (std::size_t k = 0; k < record.size(); ++k)
    curve.push_back({time[k], gap[k], upper[k], lower[k]});
  return curve;
}

Curve at_instants(Curve const& curve, std::span<double const> instants) {
  Curve result;
  for (double const time : instants) {
    auto const after = std::ranges::lower_bound(curve, time, {}, &CurvePoint::time);
    if (after == curve.end() || after == curve.begin())
      throw std::runtime_error("a force curve ends before the press cycle does");
    CurvePoint const& left = *(after - 1);
    double const share = (time - left.time) / (after->time - left.time);
    auto const between = [&](double CurvePoint::*value) {
      return left.*value + share * ((*after).*value - left.*value);
    };
    result.push_back({time, between(&CurvePoint::gap), between(&CurvePoint::upper_force),
                      between(&CurvePoint::lower_force)});
  }
  return result;
}

Curve mean_of(std::vector<Curve> const& curves) {
  Curve mean = curves.front();
  double const share = 1.0 / static_cast<double>(curves.size());
  for (std::size_t k = 0; k < mean.size(); ++k) {
    mean[k].upper_force = mean[k].lower_force = 0.0;
    for (Curve const& curve : curves) {
      mean[k].upper_force += share * curve.at(k).upper_force;
      mean[k].lower_force += share * curve.at(k).lower_force;
    }
  }
  return mean;
}

double peak_force(Curve const& curve) {
  return std::ranges::max_element(curve, {}, &CurvePoint::upper_force)->upper_force;
}

double largest_difference(Curve const& a, Curve const& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    largest = std::max(largest, std::abs(a[k].upper_force - b.at(k).upper_force));
  return largest;
}

} // namespace crosscode
