#include "coupling/study/size_trend.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

using Eigen::VectorXd;

constexpr double least_packing = 0.3, most_packing = 0.99; // virtual, of grains of any shape

double packed_porosity(std::vector<GrainClass> coarse, double fine_share, double index, double beta,
                       double size) {
  for (auto& one : coarse) {
    one.share *= 1.0 - fine_share;
    one.packing = beta;
  }
  coarse.push_back({size, fine_share, beta});
  return 1.0 - packed_fraction(std::move(coarse), index);
}

} // namespace

TrendForm linear_form() {
  return {"linear", {"a", "b"}, [](VectorXd const& p, double D) { return p[0] + p[1] * D; },
          true,     {},         {}};
}

TrendForm quadratic_form() {
  return {"quadratic",
          {"a", "b", "c"},
          [](VectorXd const& p, double D) { return p[0] + p[1] * D + p[2] * D * D; },
          true,
          {},
          {}};
}

TrendForm logarithmic_form() {
  return {"logarithmic",
          {"a", "b"},
          [](VectorXd const& p, double D) { return p[0] + p[1] * std::log(D); },
          true,
          {},
          {}};
}

TrendForm power_form(std::vector<double> const& sizes, std::vector<double> const& responses) {
  // a is the value at the largest size, so that its bounds are of the data's order.
  double const reference = sizes.empty() ? 1.0 : std::ranges::max(sizes);
  double const largest = responses.empty() ? 1.0 : std::ranges::max(responses);
  return {"power",
          {"a (at the largest size)", "b"},
          [reference](VectorXd const& p, double D) { return p[0] * std::pow(D / reference, p[1]); },
          false,
          VectorXd{{0.0, -8.0}},
          VectorXd{{4.0 * largest, 8.0}},
          true};
}

TrendForm packing_form(double fine_share, double compaction_index, double largest_size) {
  return {"packing model, one coarse size",
          {"beta", "ln(coarse size / m)"},
          [=](VectorXd const& p, double D) {
            return packed_porosity({{std::exp(p[1]), 1.0, p[0]}}, fine_share, compaction_index,
                                   p[0], D);
          },
          false,
          VectorXd{{least_packing, std::log(largest_size)}},
          VectorXd{{most_packing, std::log(100.0 * largest_size)}}};
}

TrendForm packing_form(std::vector<GrainClass> coarse, double fine_share, double compaction_index) {
  double sum = 0.0;
  for (auto const& one : coarse)
    sum += one.share;
  for (auto& one : coarse)
    one.share /= sum;
  return {"packing model, known coarse sizes",
          {"beta"},
          [=](VectorXd const& p, double D) {
            return packed_porosity(coarse, fine_share, compaction_index, p[0], D);
          },
          false,
          VectorXd::Constant(1, least_packing),
          VectorXd::Constant(1, most_packing)};
}

} // namespace coupling::study
