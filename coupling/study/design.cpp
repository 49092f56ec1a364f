#include "coupling/study/design.hpp"

#include "dem/expect.hpp"
#include "dem/packing/random_stream.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace coupling::study {
namespace {

constexpr long most_runs = 100000;
constexpr int n_draws = 1000;

void validate_size(char const* design, long n_runs) {
  VALIDATE(n_runs <= most_runs,
           fmt::format("{}: has more than {} runs (each is a simulation). Fewer factors or levels?",
                       design, most_runs));
}

Eigen::MatrixXd corners(int n_factors) {
  return full_factorial(std::vector<int>(static_cast<std::size_t>(n_factors), 2));
}

Eigen::MatrixXd draw_hypercube(int n_factors, int n_runs, dem::RandomStream& random) {
  Eigen::MatrixXd design(n_runs, n_factors);
  std::vector<int> cells(static_cast<std::size_t>(n_runs));
  for (int f = 0; f < n_factors; ++f) {
    std::iota(cells.begin(), cells.end(), 0);
    for (auto k = cells.size() - 1; k > 0; --k) // Fisher and Yates; std::shuffle is not portable
      std::swap(cells[k], cells[random.below(k + 1)]);
    for (int r = 0; r < n_runs; ++r)
      design(r, f) = (2.0 * cells[static_cast<std::size_t>(r)] + 1.0) / n_runs - 1.0;
  }
  return design;
}

/// Squared distance of the two closest runs; 0 as soon as a pair is not further apart than `least`.
double closest_squared(Eigen::MatrixXd const& design, double least) {
  double closest = std::numeric_limits<double>::infinity();
  for (Eigen::Index a = 0; a < design.rows(); ++a)
    for (Eigen::Index b = 0; b < a; ++b) {
      closest = std::min(closest, (design.row(a) - design.row(b)).squaredNorm());
      if (closest <= least)
        return 0.0;
    }
  return closest;
}

} // namespace

Eigen::MatrixXd full_factorial(std::vector<int> const& n_levels) {
  VALIDATE(!n_levels.empty(),
           "full_factorial: has no factors (there is nothing to vary). Name at least one?");
  long n_runs = 1;
  for (std::size_t f = 0; f < n_levels.size(); ++f) {
    VALIDATE(
        n_levels[f] >= 2,
        fmt::format("full_factorial: factor {} has {} level{} (a factor that does not vary has "
                    "no effect). At least 2, or hold it?",
                    f + 1, n_levels[f], n_levels[f] == 1 ? "" : "s"));
    n_runs *= n_levels[f];
    validate_size("full_factorial", n_runs);
  }
  Eigen::MatrixXd design(n_runs, static_cast<Eigen::Index>(n_levels.size()));
  for (long run = 0; run < n_runs; ++run) {
    long rest = run;
    for (auto f = n_levels.size(); f-- > 0; rest /= n_levels[f]) {
      // (2 level - (n - 1)) / (n - 1) is symmetric to the bit; -1 + 2 level / (n - 1) is not.
      int const last = n_levels[f] - 1;
      auto const level = static_cast<double>(rest % n_levels[f]);
      design(run, static_cast<Eigen::Index>(f)) = (2.0 * level - last) / last;
    }
  }
  return design;
}

Eigen::MatrixXd central_composite(int n_factors, AxialPoints axial, int n_centre) {
  VALIDATE(
      n_factors >= 2,
      fmt::format("central_composite: has {} factor{} (its corners and axial points need two). "
                  "Is full_factorial with three levels meant?",
                  n_factors, n_factors == 1 ? "" : "s"));
  VALIDATE(n_centre >= 0,
           fmt::format("central_composite: has {} centre points. 0 or more?", n_centre));
  validate_size("central_composite",
                n_factors > 16 ? most_runs + 1 : (1L << n_factors) + 2L * n_factors + n_centre);
  double const alpha =
      axial == AxialPoints::face_centred ? 1.0 : std::pow(2.0, 0.25 * n_factors); // rotatable
  Eigen::MatrixXd const cube = corners(n_factors);
  Eigen::MatrixXd design = Eigen::MatrixXd::Zero(cube.rows() + 2 * n_factors + n_centre, n_factors);
  design.topRows(cube.rows()) = cube;
  for (int f = 0; f < n_factors; ++f) {
    design(cube.rows() + 2 * f, f) = -alpha;
    design(cube.rows() + 2 * f + 1, f) = alpha;
  }
  return axial == AxialPoints::inscribed ? Eigen::MatrixXd(design / alpha) : design;
}

Eigen::MatrixXd latin_hypercube(int n_factors, int n_runs, std::uint64_t seed) {
  VALIDATE(n_factors >= 1,
           "latin_hypercube: has no factors (there is nothing to vary). Name at least one?");
  VALIDATE(n_runs >= 2,
           fmt::format("latin_hypercube: has {} run{} (an effect needs two). More runs?", n_runs,
                       n_runs == 1 ? "" : "s"));
  validate_size("latin_hypercube", n_runs);
  dem::RandomStream random(seed);
  Eigen::MatrixXd best;
  double furthest = 0.0;
  for (int draw = 0; draw < n_draws; ++draw) {
    Eigen::MatrixXd design = draw_hypercube(n_factors, n_runs, random);
    // Equal distances differ by rounding; the first of them is kept on every platform.
    double const closest = closest_squared(design, furthest * (1.0 + 1e-9));
    if (closest > 0.0) {
      furthest = closest;
      best = std::move(design);
    }
  }
  return best;
}

double closest_pair(Eigen::MatrixXd const& design) {
  return std::sqrt(closest_squared(design, 0.0));
}

} // namespace coupling::study
