#include "dem/measure/core.hpp"

#include "dem/expect.hpp"
#include "dem/measure/compact.hpp"
#include "dem/measure/contact_statistics.hpp"
#include "dem/measure/quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace dem {
namespace {

/// Integral of the section common to sphere and core over from .. to, z measured from the sphere's
/// centre.
double integrate_section(double from, double to, double R, double core_radius, double offset) {
  static QuadratureRule const rule = gauss_legendre(12);
  double const middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0.0;
  for (std::size_t k = 0; k < rule.points.size(); ++k) {
    double const z = middle + half * rule.points[k];
    double const section = std::sqrt(std::max(0.0, R * R - z * z));
    sum += rule.weights[k] * circle_overlap_area(section, core_radius, offset);
  }
  return half * sum;
}

/// Top and bottom of the grains over square columns that cover the core.
class HeightMap {
public:
  HeightMap(double core_radius, double width)
      : core_radius_(core_radius), width_(width),
        n_(std::max(1, static_cast<int>(std::ceil(2.0 * core_radius / width)))),
        top_(static_cast<std::size_t>(n_) * n_, -infinite), bottom_(top_.size(), infinite) {}

  void add(Vec3 const& centre, double R) {
    auto const [i0, i1] = columns(centre[0], R);
    auto const [j0, j1] = columns(centre[1], R);
    for (int j = j0; j <= j1; ++j)
      for (int i = i0; i <= i1; ++i) {
        double const x = distance_to_column(centre[0], i), y = distance_to_column(centre[1], j);
        double const above =
            R * R - x * x - y * y; // over the column's point nearest to the grain's axis
        if (above < 0.0)
          continue;
        std::size_t const column = static_cast<std::size_t>(j) * n_ + i;
        top_[column] = std::max(top_[column], centre[2] + std::sqrt(above));
        bottom_[column] = std::min(bottom_[column], centre[2] - std::sqrt(above));
      }
  }

  CoreRegion core(double floor) const {
    CoreRegion sum{.radius = core_radius_, .bottom = 0.0, .top = 0.0};
    int n_columns = 0;
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i < n_; ++i) {
        std::size_t const column = static_cast<std::size_t>(j) * n_ + i;
        bool const is_inside =
            std::hypot(start(i) + 0.5 * width_, start(j) + 0.5 * width_) <= core_radius_;
        if (!is_inside || top_[column] < bottom_[column])
          continue;
        ++n_columns;
        sum.top += top_[column];
        sum.bottom += bottom_[column];
      }
    if (n_columns == 0)
      return {.radius = core_radius_, .bottom = floor, .top = floor};
    return {.radius = core_radius_, .bottom = sum.bottom / n_columns, .top = sum.top / n_columns};
  }

private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  double start(int column) const { return (column - 0.5 * n_) * width_; }
  double distance_to_column(double x, int column) const {
    return std::max({start(column) - x, x - start(column) - width_, 0.0});
  }
  std::array<int, 2> columns(double x, double R) const {
    auto const at = [&](double edge) {
      return static_cast<int>(std::floor(edge / width_ + 0.5 * n_));
    };
    return {std::max(at(x - R), 0), std::min(at(x + R), n_ - 1)};
  }

  double core_radius_, width_;
  int n_;
  std::vector<double> top_, bottom_;
};

double median_diameter(Spheres const& grains) {
  std::vector<double> radii = grains.radius;
  auto const middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::ranges::nth_element(radii, middle);
  return 2.0 * *middle;
}

} // namespace

double circle_overlap_area(double a, double b, double distance) {
  if (distance >= a + b)
    return 0.0;
  double const smaller = std::min(a, b);
  if (distance <= std::abs(a - b))
    return pi * smaller * smaller;
  double const d = distance;
  double const cos_a = std::clamp((d * d + a * a - b * b) / (2.0 * d * a), -1.0, 1.0);
  double const cos_b = std::clamp((d * d + b * b - a * a) / (2.0 * d * b), -1.0, 1.0);
  double const kite = (a + b - d) * (d + a - b) * (d - a + b) * (d + a + b);
  return a * a * std::acos(cos_a) + b * b * std::acos(cos_b) - 0.5 * std::sqrt(std::max(0.0, kite));
}

double volume_in_core(Vec3 const& centre, double R, CoreRegion const& core) {
  double const offset = std::hypot(centre[0], centre[1]);
  double const from = std::max(core.bottom - centre[2], -R), to = std::min(core.top - centre[2], R);
  if (from >= to || offset - R >= core.radius)
    return 0.0;
  if (offset + R <= core.radius)
    return pi * (R * R * (to - from) - (to * to * to - from * from * from) / 3.0);
  // The section's circle touches the core's from inside or outside at these heights: integrate
  // piece by piece.
  std::vector<double> ends{from, to};
  for (double section : {std::abs(core.radius - offset), core.radius + offset}) {
    if (section >= R)
      continue;
    double const z = std::sqrt(R * R - section * section);
    for (double end : {-z, z})
      if (end > from && end < to)
        ends.push_back(end);
  }
  std::ranges::sort(ends);
  double volume = 0.0;
  for (std::size_t k = 1; k < ends.size(); ++k)
    volume += integrate_section(ends[k - 1], ends[k], R, core.radius, offset);
  return volume;
}

CoreRegion find_core(Spheres const& grains, double radius, double floor, double column_width) {
  EXPECT(radius > 0.0 && column_width >= 0.0);
  if (grains.size() == 0)
    return {.radius = radius, .bottom = floor, .top = floor};
  HeightMap map(radius, column_width > 0.0 ? column_width : median_diameter(grains));
  for (std::size_t i = 0; i < grains.size(); ++i)
    if (is_in_compact(grains, i, floor))
      map.add(grains.position[i], grains.radius[i]);
  return map.core(floor);
}

double core_porosity(Spheres const& grains, ContactStream const& contacts, CoreRegion const& core) {
  if (!(core.volume() > 0.0))
    return 1.0;
  double solid = 0.0, lenses = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    solid += volume_in_core(grains.position[i], grains.radius[i], core);
  contacts.for_each([&](Contact const& contact) {
    double const lens = contact_lens(grains, contact);
    if (lens > 0.0)
      lenses += volume_in_core(contact.point, std::cbrt(lens / (4.0 / 3.0 * pi)), core);
  });
  return 1.0 - (solid - lenses) / core.volume();
}

} // namespace dem
