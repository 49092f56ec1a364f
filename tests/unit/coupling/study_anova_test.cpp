#include "coupling/study/anova.hpp"
#include "coupling/study/design.hpp"
#include "coupling/study/replicates.hpp"
#include "coupling/study/screening.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/study_seed.hpp"
#include "tests/unit/coupling/study_support.hpp"

#include <gtest/gtest.h>

namespace {

using namespace coupling::study;
using namespace study_support;
using Eigen::MatrixXd;
using Eigen::VectorXd;

AnovaRow const& row(std::vector<AnovaRow> const& rows, std::string const& name) {
  return *std::ranges::find(rows, name, &AnovaRow::name);
}

/// Residual sum of squares of the model without some terms.
double rss(Observations const& data, std::vector<Term> const& terms) {
  return fit_response_surface(data, terms).fit.residual_ss;
}

} // namespace

// x = -1, -1, 0, 0, 1, 1; y = 1, 3, 4, 4, 6, 8. Means 2, 4, 7: pure error 2 + 0 + 2 = 4 with 3
// degrees; mean of all 26/6, slope 10/4 = 2.5: SS 25; total 142 - 676/6 = 29.333; residual 4.333,
// lack of fit 1/3 with 1 degree, F = (1/3) / (4/3) = 1/4.
TEST(Anova, IsThatOfALineByHand) {
  MatrixXd x(6, 1);
  x << -1, -1, 0, 0, 1, 1;
  VectorXd y(6);
  y << 1, 3, 4, 4, 6, 8;
  auto const anova = analyse_variance(fit_response_surface(observed(x, y), linear_terms(1)));
  EXPECT_NEAR(anova.total.ss, 142.0 - 676.0 / 6.0, 1e-12);
  EXPECT_EQ(anova.total.df, 5);
  EXPECT_NEAR(anova.model.ss, 25.0, 1e-12);
  EXPECT_NEAR(anova.terms[0].ss, 25.0, 1e-12);
  EXPECT_NEAR(anova.terms[0].sequential_ss, 25.0, 1e-12);
  EXPECT_NEAR(anova.residual.ss, 13.0 / 3.0, 1e-12);
  EXPECT_EQ(anova.residual.df, 4);
  EXPECT_NEAR(anova.model.f, 25.0 / (13.0 / 12.0), 1e-12);
  EXPECT_NEAR(anova.pure_error.ss, 4.0, 1e-13);
  EXPECT_EQ(anova.pure_error.df, 3);
  EXPECT_NEAR(anova.lack_of_fit.ss, 1.0 / 3.0, 1e-12);
  EXPECT_EQ(anova.lack_of_fit.df, 1);
  EXPECT_NEAR(anova.lack_of_fit.f, 0.25, 1e-12);
  // F with 1 and 3 degrees is t^2 with 3: P(|t| > 1/2) = 0.651448 (table of Student's t).
  EXPECT_NEAR(anova.lack_of_fit.p, 0.651448, 1e-6);
}

TEST(Anova, AdjustedSumsAreWhatTheResidualGrowsBy) {
  Noise noise(8);
  MatrixXd coded(16, 2); // unbalanced, with replicates
  coded << latin_hypercube(2, 12, 2), 0, 0, 0, 0, 0.5, 0.5, 0.5, 0.5;
  auto const data = observed(coded, noise.vector(16) + 2.0 * coded.col(0));
  auto const all = quadratic_terms(2);
  auto const surface = fit_response_surface(data, all);
  auto const anova = analyse_variance(surface);
  double const full = surface.fit.residual_ss;
  // Squares and the interaction can leave and keep the model hierarchical.
  EXPECT_TRUE(near::relative(row(anova.terms, "A^2").ss,
                             rss(data, {{0}, {1}, {0, 1}, {1, 1}}) - full, 1e-10));
  EXPECT_TRUE(
      near::relative(row(anova.groups, "square").ss, rss(data, {{0}, {1}, {0, 1}}) - full, 1e-10));
  EXPECT_EQ(row(anova.groups, "square").df, 2);
  EXPECT_TRUE(
      near::relative(row(anova.groups, "interaction").ss, row(anova.terms, "A*B").ss, 1e-12));
  EXPECT_TRUE(near::relative(anova.model.ss, anova.total.ss - full, 1e-10));
  // Sequential sums: the last is the adjusted one, and all add up to the model's.
  EXPECT_TRUE(near::relative(anova.terms.back().sequential_ss, anova.terms.back().ss, 1e-10));
  double sum = 0.0;
  for (auto const& term : anova.terms)
    sum += term.sequential_ss;
  EXPECT_TRUE(near::relative(sum, anova.model.ss, 1e-12));
  EXPECT_TRUE(
      near::relative(anova.terms[0].sequential_ss, anova.total.ss - rss(data, {{0}}), 1e-10));
  // t^2 = F of each term.
  auto const coefficients = surface.coefficients();
  for (std::size_t t = 0; t < all.size(); ++t)
    EXPECT_TRUE(near::relative(std::pow(coefficients[t + 1].t, 2), anova.terms[t].f, 1e-10));
  EXPECT_EQ(anova.pure_error.df, 2);
  EXPECT_EQ(anova.lack_of_fit.df, 16 - 6 - 2);
  EXPECT_TRUE(near::relative(anova.lack_of_fit.ss + anova.pure_error.ss, full, 1e-12));
}

TEST(Anova, WithoutReplicatesHasNoLackOfFit) {
  auto const anova = analyse_variance(fit_response_surface(
      study_seed::observations("table7", "EDEM", "max_force [N]"), quadratic_terms(2)));
  EXPECT_EQ(anova.pure_error.df, 0);
  EXPECT_TRUE(std::isnan(anova.lack_of_fit.f));
  EXPECT_TRUE(std::isnan(anova.lack_of_fit.p));
  EXPECT_EQ(replicates(full_factorial({3, 3})).size(), 9u);
}

// Three factors, 0.01, 0.02 and 0.04: times 3, 2, 1 and never falling: 0.03, 0.04, 0.04.
TEST(Screening, AdjustsAfterHolm) {
  auto const near_to = [](std::vector<double> const& a, std::vector<double> const& b) {
    for (std::size_t k = 0; k < a.size(); ++k)
      EXPECT_NEAR(a[k], b[k], 1e-15);
  };
  near_to(adjust_holm({0.04, 0.01, 0.02}), {0.04, 0.03, 0.04});
  near_to(adjust_holm({0.9, 0.6}), {1.0, 1.0});
  EXPECT_TRUE(std::isnan(adjust_holm({0.01, std::nan("")})[1]));
  near_to({adjust_holm({0.01, std::nan("")})[0]}, {0.01});
}

TEST(Screening, FindsWhatMatters) {
  Noise noise(21);
  MatrixXd const coded = central_composite(3, AxialPoints::face_centred, 3);
  VectorXd const y = 10.0 * coded.col(1) +
                     3.0 * (coded.col(0).array() * coded.col(1).array()).matrix() +
                     0.5 * noise.vector(coded.rows());
  auto const found = screen_factors(fit_response_surface(observed(coded, y), quadratic_terms(3)));
  EXPECT_EQ(found[0].factor, "B");
  EXPECT_EQ(found[0].largest_term, "B");
  EXPECT_EQ(found[0].df, 4); // B, A*B, B*C, B^2
  EXPECT_TRUE(found[0].is_influential);
  EXPECT_EQ(found[1].factor, "A");
  EXPECT_EQ(found[1].largest_term, "A*B");
  EXPECT_TRUE(found[1].is_influential);
  EXPECT_FALSE(found[2].is_influential) << found[2].p_holm;
  EXPECT_NE(found[2].statement.find("C is not influential on y"), std::string::npos)
      << found[2].statement;
}

// Section 3.1: with LIGGGHTS modulus and cohesion are the most influential on all results.
TEST(Screening, FindsTheSeedsFactors) {
  std::vector<ResponseSurface> surfaces;
  for (char const* column : {"max_force [N]", "porosity [%]", "shape_quality [1]"})
    surfaces.push_back(fit_response_surface(study_seed::observations("table6", "LIGGGHTS", column),
                                            quadratic_terms(3)));
  auto const overall = screen_factors(surfaces);
  EXPECT_EQ(overall[0].factor, "E");
  EXPECT_EQ(overall[1].factor, "CED");
  EXPECT_EQ(overall[2].factor, "D");
  EXPECT_EQ(overall[0].n_influential, 2); // shape quality: p = 0.1 after Holm
  double shares = 0.0;
  for (auto const& surface : surfaces)
    for (auto const& one : screen_factors(surface))
      shares += one.factor == "E" ? one.share : 0.0;
  EXPECT_NEAR(overall[0].mean_share, shares / 3.0, 1e-14);
  auto const force = screen_factors(surfaces[0]);
  EXPECT_EQ(force[0].factor, "E");
  EXPECT_GT(force[0].share, 0.99);
}

// 2000 responses of pure noise: some factor is called influential in at most 5 % of them.
TEST(Screening, IsFooledByNoiseAsOftenAsItSays) {
  Noise noise(77);
  MatrixXd const coded = central_composite(3, AxialPoints::face_centred, 3);
  constexpr int n = 2000;
  int fooled = 0, single = 0;
  for (int set = 0; set < n; ++set) {
    auto const found = screen_factors(
        fit_response_surface(observed(coded, noise.vector(coded.rows())), quadratic_terms(3)));
    fooled += std::ranges::any_of(found, &FactorInfluence::is_influential) ? 1 : 0;
    single += std::ranges::find(found, "A", &FactorInfluence::factor)->p < 0.05 ? 1 : 0;
  }
  RecordProperty("fooled", fooled);
  EXPECT_TRUE(is_within_chance(single, n, 0.05)) << single;
  EXPECT_LT(fooled, 0.05 * n + 4.9 * std::sqrt(n * 0.05 * 0.95)) << fooled;
  EXPECT_GT(fooled, 0.02 * n) << "Holm is not that much on the safe side: " << fooled;
}

TEST(Screening, SaysWhenItCannotTell) {
  auto const saturated = screen_factors(fit_response_surface(
      observed(full_factorial({2, 2}), VectorXd::LinSpaced(4, 1, 5)), interaction_terms(2)));
  EXPECT_FALSE(saturated[0].is_influential);
  EXPECT_NE(saturated[0].statement.find("no degree of freedom is left"), std::string::npos);
  auto const constant = screen_factors(fit_response_surface(
      observed(full_factorial({3, 3}), VectorXd::Constant(9, 5.0), "SQC"), quadratic_terms(2)));
  EXPECT_EQ(constant[0].statement, "SQC does not vary, so A has no effect on it to be seen");
  EXPECT_FALSE(constant[0].is_influential);
  EXPECT_EQ(message_of([] { screen_factors(std::vector<ResponseSurface>{}); }),
            "screening: has no response. Which results are meant?");
}
