#include "coupling/reduced/packing_scatter.hpp"

#include "coupling/diagnosis/error_terms.hpp"
#include "coupling/reduced/press_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace coupling::reduced {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double grains_of_the_source = 2204.0;
constexpr PackingScatter of_the_source{
    .stress = 0.011, .punch = 0.002, .wall_stress = 0.005, .wall = 0.0106, .free_height = 0.0024};

/// Natural strain of closing in which as much is rearranged as in one of opening.
constexpr double opening_share = 1.0 / 2.5;

double matern(double apart, double length) {
  return diagnosis::matern_3_2(apart, length);
}
double together(double apart) {
  return 0.5 + 0.5 * matern(apart, 0.045);
}
double punch_alone(double apart) {
  return matern(apart, 0.02) / 3.0 + 2.0 * matern(apart, 0.12) / 3.0;
}
double wall_alone(double apart) {
  return matern(apart, 0.08);
}

/// Where the bed is and has been, for every row.
std::vector<Vector2d> places_of_rows(Press const& nominal, PressPlan const& plan) {
  std::vector<Vector2d> places;
  for (auto const& run : plan.runs) {
    auto const cycle = press_cycle(nominal.pressed, nominal.machine, run.course, run.times);
    std::vector<double> smallest;
    for (auto const& at : cycle)
      smallest.push_back(smallest.empty() ? at.height : std::min(smallest.back(), at.height));
    for (auto const& block : run.blocks)
      for (auto const& row : block.rows) {
        // A number of the whole cycle belongs to its turn.
        bool const is_scalar = block.phase == diagnosis::Phase::after;
        auto const at = is_scalar ? smallest.size() - 1 : row.places[1];
        double const height = is_scalar ? smallest.back() : cycle[at].height;
        places.emplace_back(std::log(smallest[at]),
                            opening_share * std::log(height / smallest[at]));
      }
  }
  return places;
}

enum class Kind { upper, lower, wall, other };
Kind kind_of(std::string const& channel) {
  if (channel == "upper_punch_force" || channel == "max_force")
    return Kind::upper;
  if (channel == "lower_punch_force")
    return Kind::lower;
  return channel == "wall_radial_pressure" ? Kind::wall : Kind::other;
}

/// What a row departs by.
struct RowScatter {
  Kind kind = Kind::other;
  double scale = 0.0; ///< sqrt(F F_m); of a height itself
  Vector2d place = Vector2d::Zero();
};

std::vector<RowScatter> scatter_of_rows(Press const& nominal, PressPlan const& plan,
                                        VectorXd const& rows) {
  auto const places = places_of_rows(nominal, plan);
  std::vector<RowScatter> scatter;
  for (auto const& run : plan.runs) {
    std::map<std::string, double> largest;
    auto row = static_cast<Index>(scatter.size());
    for (auto const& block : run.blocks)
      for (std::size_t k = 0; k < block.rows.size(); ++k)
        largest[block.channel] = std::max(largest[block.channel], std::abs(rows[row++]));
    for (auto const& block : run.blocks)
      for (std::size_t k = 0; k < block.rows.size(); ++k) {
        auto const at = scatter.size();
        scatter.push_back(
            {kind_of(block.channel),
             block.channel == "compact_height" || kind_of(block.channel) != Kind::other
                 ? std::sqrt(std::abs(rows[static_cast<Index>(at)]) * largest[block.channel])
                 : 0.0,
             places[at]});
      }
  }
  return scatter;
}

double covariance_of(RowScatter const& a, RowScatter const& b, PackingScatter const& of) {
  double const scale = a.scale * b.scale, apart = (a.place - b.place).norm();
  auto const shared = [&](Kind kind) { return kind == Kind::wall ? of.wall_stress : of.stress; };
  if (a.kind == Kind::other || b.kind == Kind::other)
    return 0.0;
  double sum = shared(a.kind) * shared(b.kind) * together(apart);
  if (a.kind == b.kind)
    sum += a.kind == Kind::wall ? of.wall * of.wall * wall_alone(apart)
                                : of.punch * of.punch * punch_alone(apart);
  return scale * sum;
}

} // namespace

PackingScatter packing_scatter(double n_grains) {
  if (n_grains <= 0.0)
    return {};
  double const q = std::sqrt(grains_of_the_source / n_grains);
  auto const& one = of_the_source;
  return {.stress = q * one.stress,
          .punch = q * one.punch,
          .wall_stress = q * one.wall_stress,
          .wall = q * one.wall,
          .free_height = q * one.free_height};
}

MatrixXd packing_covariance(Press const& nominal, PressPlan const& plan,
                            PackingScatter const& scatter) {
  auto const rows = scatter_of_rows(nominal, plan, predict_plan(nominal, plan));
  auto const n = static_cast<Index>(rows.size());
  MatrixXd covariance(n, n);
  for (Index i = 0; i < n; ++i) {
    auto const& row = rows[static_cast<std::size_t>(i)];
    for (Index k = 0; k < n; ++k)
      covariance(i, k) = covariance_of(row, rows[static_cast<std::size_t>(k)], scatter);
    if (row.kind == Kind::other)
      covariance(i, i) = std::pow(scatter.free_height * row.scale, 2);
  }
  return covariance;
}

MatrixXd apart_by_run(MatrixXd covariance, PressPlan const& plan) {
  Index first = 0;
  for (auto const& run : plan.runs) {
    Index n = 0;
    for (auto const& block : run.blocks)
      n += static_cast<Index>(block.rows.size());
    Index const rest = covariance.rows() - first - n;
    covariance.block(first, first + n, n, rest).setZero();
    covariance.block(first + n, first, rest, n).setZero();
    first += n;
  }
  return covariance;
}

} // namespace coupling::reduced
