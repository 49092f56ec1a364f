#include "tests/diagnosis/hide/column.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hidden {
namespace {

constexpr double pi = std::numbers::pi;

double height_of(std::array<Slice, n_slices> const& slices) {
  double sum = 0.0;
  for (auto const& slice : slices)
    sum += slice.height;
  return sum;
}

template <class Function> double root(Function const& f, double low, double high) {
  double const at_low = f(low), at_high = f(high);
  if (at_low >= 0.0)
    return low;
  if (at_high <= 0.0)
    return high;
  std::uintmax_t most = 60;
  auto const [a, b] = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(44), most);
  return 0.5 * (a + b);
}

} // namespace

Column::Column(BedLaw const& law, double mass, double wall_stiffness, double die_yield)
    : law_(law), volume_(mass / Powder::density), wall_stiffness_(wall_stiffness),
      die_yield_(die_yield), slices_{} {}

Slice Column::next(Slice const& old, double depth, double force, double top, double bore) const {
  Slice slice = old;
  slice.above = slice.below = force;
  double const start_area = 0.25 * pi * bore * bore;
  // The faces differ by half a percent: three passes leave 1e-9.
  for (int pass = 0; pass < 3; ++pass) {
    slice.stress = 0.5 * (slice.above + slice.below) / start_area;
    double const radial = law_.radial(slice.stress, old.largest);
    double const wide = bore + die_yield_ * radial;
    slice.height =
        volume_ / n_slices /
        (law_.solid_fraction(slice.stress, old.largest, old.densest) * 0.25 * pi * wide * wide);
    slice.centre = top - 0.5 * slice.height;
    double const limit = law_.friction(depth, radial) * std::max(radial, 0.0);
    double const down = is_touched_ ? old.centre - slice.centre : 0.0;
    // Pressed harder the layer is stiffer: the way that turns friction round grows as p^0.25 only.
    double const stiff = wall_stiffness_ * std::pow(std::max(radial, 0.0) / (30 * MPa), 0.75);
    slice.shear = std::clamp(old.shear + stiff * down, -limit, limit);
    slice.below = slice.above - slice.shear * pi * bore * slice.height;
  }
  if (slice.stress > old.largest) {
    slice.largest = slice.stress;
    slice.densest = law_.loaded(slice.stress);
  }
  return slice;
}

std::array<Slice, n_slices> Column::marched(double top_stress, double top, double bore) const {
  std::array<Slice, n_slices> slices = slices_;
  double force = top_stress * 0.25 * pi * bore * bore;
  for (int i = 0; i < n_slices; ++i) {
    auto& slice = slices[static_cast<std::size_t>(i)];
    slice = next(slice, (i + 0.5) / n_slices, force, top, bore);
    force = slice.below;
    top -= slice.height;
  }
  return slices;
}

std::array<Slice, n_slices> Column::balanced(double height, double bore) const {
  auto const room = [&](double stress) {
    return height - height_of(marched(stress, height, bore));
  };
  if (room(0.0) >= 0.0) { // the upper punch is away: the column stands as high as it likes
    auto const free = [&](double top) { return top - height_of(marched(0.0, top, bore)); };
    return marched(0.0, root(free, 0.3 * height, height), bore);
  }
  // From step to step the stress changes little: a narrow bracket is tried first.
  double const last = slices_.front().stress;
  double const near = 0.9 * last;
  double const low = room(near) < 0.0 ? near : 0.0;
  double high = 1.1 * last + 0.3 * MPa;
  while (room(high) < 0.0 && high < 1e10)
    high *= 2.0;
  return marched(root(room, low, high), height, bore);
}

ColumnForces Column::forces_of(std::array<Slice, n_slices> const& slices) const {
  ColumnForces forces{.upper = slices.front().above, .lower = slices.back().below};
  constexpr int quarter = n_slices / 4;
  for (int i = 0; i < quarter; ++i) {
    auto const& top = slices[static_cast<std::size_t>(i)];
    auto const& bottom = slices[static_cast<std::size_t>(n_slices - 1 - i)];
    forces.radial_top += law_.radial(top.stress, top.largest) / quarter;
    forces.radial_bottom += law_.radial(bottom.stress, bottom.largest) / quarter;
  }
  return forces;
}

ColumnForces Column::tried(double height, double bore) const {
  return forces_of(balanced(height, bore));
}

ColumnForces Column::press(double height, double bore) {
  slices_ = balanced(height, bore);
  is_touched_ = true;
  return forces_of(slices_);
}

double Column::ejection_force(double bore) const {
  double force = 0.0;
  for (int i = 0; i < n_slices; ++i) {
    auto const& slice = slices_[static_cast<std::size_t>(i)];
    double const radial = law_.residual_radial(slice.largest);
    force += 1.1 * law_.friction((i + 0.5) / n_slices, radial) * radial * pi * bore * slice.height;
  }
  return force;
}

double Column::free_height(double bore) const {
  double sum = 0.0;
  for (auto const& slice : slices_)
    sum += volume_ / n_slices /
           (law_.solid_fraction(0.0, slice.largest, slice.densest) * 0.25 * pi * bore * bore);
  return sum;
}

} // namespace hidden
