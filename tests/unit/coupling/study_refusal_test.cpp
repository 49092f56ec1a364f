// What a design cannot tell is refused by name.
#include "coupling/study/design.hpp"
#include "coupling/study/estimability.hpp"
#include "tests/unit/coupling/study_support.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace coupling::study;
using namespace study_support;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::string refusal(MatrixXd const& coded, std::vector<Term> const& terms) {
  return message_of([&] {
    validate_estimable(observed(coded, VectorXd::LinSpaced(coded.rows(), 1.0, 2.0), "F"), terms);
  });
}

} // namespace

TEST(Estimability, RefusesTooFewRuns) {
  MatrixXd const five = full_factorial({3, 3}).topRows(5);
  EXPECT_EQ(refusal(five, quadratic_terms(2)),
            "response surface of F: has 5 runs for 6 terms (intercept, A, B, A*B, A^2, B^2; each "
            "needs a run, and one more to see an error). At least 6 runs, or fewer terms?");
  MatrixXd const repeated = full_factorial({2, 2}).replicate(2, 1);
  EXPECT_EQ(refusal(repeated, quadratic_terms(2)),
            "response surface of F: has 8 runs at 4 different points for 6 terms (intercept, A, B, "
            "A*B, A^2, B^2; each needs a point). At least 6 points, or fewer terms?");
}

TEST(Estimability, RefusesAConstantFactor) {
  MatrixXd coded = full_factorial({3, 3});
  coded.col(1).setConstant(0.5);
  EXPECT_EQ(
      refusal(coded, linear_terms(2)),
      "response surface of F: B = 0.5 (coded) in all 9 runs (its effect cannot be seen). Vary "
      "it, or leave it out?");
}

TEST(Estimability, RefusesFactorsThatMoveTogether) {
  MatrixXd coded = full_factorial({3, 3}).replicate(1, 2);
  coded.col(2) = -0.5 * coded.col(0).array() - 0.25;
  EXPECT_EQ(refusal(coded.leftCols(3), linear_terms(3)),
            "response surface of F: A and C move together (coded C = -0.5 A - 0.25 in all 9 runs; "
            "their effects cannot be told apart). Vary one alone?");
  coded.col(2) = coded.col(1);
  EXPECT_EQ(refusal(coded.leftCols(3), linear_terms(3)),
            "response surface of F: B and C move together (coded C = 1 B + 0 in all 9 runs; their "
            "effects cannot be told apart). Vary one alone?");
}

TEST(Estimability, NamesTermsThatAreSumsOfOthers) {
  // Two levels: all squares are 1.
  EXPECT_EQ(refusal(full_factorial({2, 2, 2}), {{0}, {1}, {0, 0}, {1, 1}}),
            "response surface of F: A^2 = 1, B^2 = 1 in all 8 runs (such terms cannot be told "
            "apart; a square needs three levels of its factor). Add runs that part them, or leave "
            "them out?");
  // Half a fraction with C = A B.
  MatrixXd half(4, 3);
  half << -1, -1, 1, -1, 1, -1, 1, -1, -1, 1, 1, 1;
  EXPECT_EQ(refusal(half, {{0}, {1}, {0, 1}}), "no error");
  EXPECT_EQ(refusal(half.replicate(2, 1), {{0}, {1}, {2}, {0, 1}}),
            "response surface of F: has 8 runs at 4 different points for 5 terms (intercept, A, B, "
            "C, A*B; each needs a point). At least 5 points, or fewer terms?");
  MatrixXd with_centre(5, 3);
  with_centre << half, 0, 0, 0;
  EXPECT_EQ(refusal(with_centre, {{0}, {1}, {2}, {0, 1}}),
            "response surface of F: A*B = C in all 5 runs (such terms cannot be told apart; a "
            "square needs three levels of its factor). Add runs that part them, or leave it out?");
  // Axial points alone: A^2 + B^2 + C^2 = 1.
  MatrixXd const star = central_composite(3, AxialPoints::face_centred, 0).bottomRows(6);
  EXPECT_EQ(refusal(star.replicate(2, 1), {{0}, {1}, {2}, {0, 0}, {1, 1}}), "no error");
  MatrixXd lean = star;
  lean.row(0) *= 0.5; // the run parts A^2 from the sum
  EXPECT_EQ(refusal(lean, {{0}, {1}, {2}, {0, 0}, {1, 1}}), "no error");
}

TEST(Estimability, RefusesWhatIsNoNumber) {
  MatrixXd const coded = full_factorial({3, 3});
  VectorXd y = VectorXd::LinSpaced(9, 1.0, 2.0);
  auto const act = [&](MatrixXd const& x, VectorXd const& response) {
    return message_of([&] { validate_estimable(observed(x, response, "F"), linear_terms(2)); });
  };
  y[2] = not_a_number;
  EXPECT_EQ(act(coded, y),
            "response surface of F: run 3: F = nan (a run without a result cannot be "
            "fitted). Leave the run out?");
  MatrixXd broken = coded;
  broken(4, 1) = not_a_number;
  EXPECT_EQ(act(broken, VectorXd::Ones(9)),
            "response surface of F: run 5: B = nan (a factor is a number). Was it read?");
  EXPECT_EQ(act(coded, VectorXd::Ones(8)),
            "response surface of F: F has 8 values for 9 runs. Is a run's result missing?");
  EXPECT_EQ(act(MatrixXd(0, 2), VectorXd(0)),
            "response surface of F: has no runs (there is nothing to fit). Which runs are meant?");
  EXPECT_EQ(message_of([&] {
              validate_estimable(observed(coded, VectorXd::Ones(9), ""), linear_terms(2));
            }),
            "response surface: has no response. Which result is meant?");
  auto nameless = observed(coded, VectorXd::Ones(9), "F");
  nameless.factor_names.pop_back();
  EXPECT_EQ(message_of([&] { validate_estimable(nameless, linear_terms(2)); }),
            "response surface of F: has 1 factor in 2 columns. Is a name missing?");
}

TEST(Estimability, RefusesTermsThatAreNone) {
  MatrixXd const coded = full_factorial({3, 3});
  EXPECT_EQ(
      refusal(coded, {{0}, {0, 0}, {0, 1}}),
      "response surface of F: A*B stands without B (its meaning would hang on where the coded "
      "zero is). Add B?");
  EXPECT_EQ(refusal(coded, {{0}, {0}}), "response surface of F: A is there twice. Leave one out?");
  EXPECT_EQ(refusal(coded, {{2}}), "response surface of F: a term has the factors [2] (one or two "
                                   "of 0 to 1, in ascending order). Which is meant?");
  EXPECT_EQ(refusal(coded, {{0}, {1}, {0, 0, 1}}),
            "response surface of F: a term has the factors [0, 0, 1] (one or two of 0 to 1, in "
            "ascending order). Which is meant?");
}
