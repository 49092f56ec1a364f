#pragma once

#include "tests/diagnosis/grains/curve.hpp"
#include "tests/diagnosis/hide/press.hpp"

#include <Eigen/Dense>

#include <vector>

namespace hidden {

/// Readings of one channel at given gaps, linear between the moments of a stroke, which come by
/// falling gap.
Eigen::VectorXd at_gaps(std::vector<Moment> const& stroke, double Moment::*reading,
                        std::vector<double> const& gaps);

/// n gaps at equal distances from where the upper force is 1 % of its peak to the turn.
std::vector<double> gaps_of(std::vector<Pressed> const& stroke, double peak, int n);

/// The same bed when the punch turns before it came down: loading to there, and unloading, which in
/// heights over the lowest one and forces over the largest is the same from any turn near by.
Curve turned_at(Curve const& curve, double gap);

/// The same bed with another mass, by a share: stresses hang on the solid fraction alone.
Curve with_mass(Curve curve, double share);

/// The same in a bore that is wider by a share: less solid at a gap, on more area.
Curve with_bore(Curve curve, double share);

} // namespace hidden
