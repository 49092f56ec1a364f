// Response surfaces and their analysis of variance against R's lm, drop1, anova and predict.
#include "coupling/study/anova.hpp"
#include "coupling/study/design.hpp"
#include "coupling/study/screening.hpp"
#include "tests/crosscode/liggghts/child_process.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/coupling/study_seed.hpp"
#include "tests/unit/coupling/study_support.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

namespace {

using namespace coupling::study;
using Eigen::VectorXd;

using Said = std::map<std::string, double>; ///< what R printed

constexpr double bar = 1e-8; // relative

/// "A*B" as "A:B", "A^2" as "I(A^2)", "intercept" as "(Intercept)".
std::string in_r(std::string name) {
  if (name == "intercept")
    return "(Intercept)";
  if (auto const star = name.find('*'); star != std::string::npos)
    name[star] = ':';
  return name.find('^') == std::string::npos ? name : "I(" + name + ")";
}

std::string table_of(Observations const& data) {
  std::string text;
  for (auto const& name : data.factor_names)
    text += name + ",";
  text += "y\n";
  for (Eigen::Index run = 0; run < data.coded.rows(); ++run) {
    for (double const x : data.coded.row(run))
      text += fmt::format("{:.17g},", x);
    text += fmt::format("{:.17g}\n", data.response[run]);
  }
  return text;
}

Said ask_r(Observations const& data, std::vector<Term> const& terms) {
  support::ScratchFolder const folder;
  support::put_bytes(folder / "runs.csv", table_of(data));
  std::vector<std::string> command{crosscode::find_program("Rscript", "r-base-core"), "--vanilla",
                                   PRESSCHECK_SOURCE_DIR "/tests/crosscode/r/analyse.R",
                                   "runs.csv"};
  for (auto const& term : terms)
    command.push_back(in_r(name_of(term, data.factor_names)));
  auto const cost = crosscode::run_program(command, folder.path());
  std::istringstream output(support::bytes_of(folder / "output.txt"));
  if (cost.exit_status != 0)
    throw std::runtime_error("R failed: " + output.str());
  Said said;
  for (std::string key, value; output >> key >> value;)
    said[key] = std::stod(value);
  return said;
}

/// Counts what was compared, so that nothing is passed over in silence.
class Comparer {
public:
  explicit Comparer(Said said) : said_(std::move(said)) {}

  /// @param floor  below which a number is a rounding of zero
  void expect(std::string const& key, double ours, double floor = 0.0) {
    auto const found = said_.find(key);
    ASSERT_NE(found, said_.end()) << key;
    double const apart = std::abs(ours - found->second);
    EXPECT_LE(apart, bar * std::abs(found->second) + floor)
        << key << ": " << ours << " against " << found->second;
    // Where a number is a rounding of zero, its relative departure says nothing.
    if (std::abs(found->second) * bar > 1e-3 * floor)
      largest_ = std::max(largest_, apart / std::abs(found->second));
    ++n_;
  }
  std::size_t n_said() const { return said_.size(); }
  std::size_t n_compared() const { return n_; }
  double largest() const { return largest_; }

private:
  Said said_;
  std::size_t n_ = 0;
  double largest_ = 0.0;
};

void compare_coefficients(Comparer& r, ResponseSurface const& surface, double tiny) {
  for (auto const& one : surface.coefficients()) {
    auto const name = "/" + in_r(one.name);
    r.expect("value" + name, one.value, tiny);
    r.expect("standard_error" + name, one.standard_error);
    r.expect("t" + name, one.t, 1e-10);
    r.expect("p" + name, one.p);
    r.expect("lower" + name, one.lower, tiny);
    r.expect("upper" + name, one.upper, tiny);
  }
  r.expect("residual_sd", surface.fit.residual_sd());
  r.expect("r_squared", surface.r_squared());
  r.expect("adjusted_r_squared", surface.adjusted_r_squared());
  r.expect("press", surface.fit.press());
}

/// Near F = 0 the probability falls with the root of F, so that a rounding of F shows.
double p_floor(double f) {
  return f < 1e-10 ? 1e-5 : 0.0;
}

void compare_anova(Comparer& r, ResponseSurface const& surface) {
  auto const anova = analyse_variance(surface);
  double const tiny = 1e-14 * anova.total.ss;
  r.expect("model/f", anova.model.f);
  r.expect("model/p", anova.model.p);
  for (auto const& term : anova.terms) {
    auto const name = "/" + in_r(term.name);
    r.expect("adjusted_ss" + name, term.ss, tiny);
    r.expect("f" + name, term.f, 1e-10);
    r.expect("p_of_f" + name, term.p, p_floor(term.f));
    r.expect("sequential_ss" + name, term.sequential_ss, tiny);
  }
  r.expect("sequential_ss/Residuals", anova.residual.ss);
  auto const groups = [&](std::string const& name, double ss, double f, double p) {
    r.expect("group_ss/" + name, ss, tiny);
    r.expect("group_f/" + name, f, 1e-10);
    r.expect("group_p/" + name, p, p_floor(f));
  };
  for (auto const& one : anova.groups)
    groups(one.name, one.ss, one.f, one.p);
  for (auto const& one : screen_factors(surface))
    groups(one.factor, one.ss, one.f, one.p);
  if (anova.pure_error.df > 0) {
    r.expect("pure_error_ss", anova.pure_error.ss);
    r.expect("lack_ss", anova.lack_of_fit.ss);
    r.expect("lack_f", anova.lack_of_fit.f);
    r.expect("lack_p", anova.lack_of_fit.p);
  }
}

void compare_prediction(Comparer& r, ResponseSurface const& surface) {
  VectorXd x(surface.n_factors());
  for (Eigen::Index f = 0; f < x.size(); ++f)
    x[f] = 0.2 + 0.3 * static_cast<double>(f);
  auto const at = surface.predict(x);
  r.expect("confidence/value", at.value);
  r.expect("confidence/lower", at.mean_lower);
  r.expect("confidence/upper", at.mean_upper);
  r.expect("prediction/value", at.value);
  r.expect("prediction/lower", at.run_lower);
  r.expect("prediction/upper", at.run_upper);
}

void compare_with_r(Observations const& data, std::vector<Term> const& terms,
                    std::string const& name) {
  Comparer r(ask_r(data, terms));
  auto const surface = fit_response_surface(data, terms);
  compare_coefficients(r, surface, 1e-13 * data.response.cwiseAbs().maxCoeff());
  compare_anova(r, surface);
  compare_prediction(r, surface);
  EXPECT_EQ(r.n_compared(), r.n_said()) << "R said more than was compared";
  ::testing::Test::RecordProperty(
      name, fmt::format("{} numbers within {:.2g}", r.n_compared(), r.largest()));
}

} // namespace

TEST(StudyAgainstR, AgreesOnTheSeedsTables) {
  for (char const* table : {"table6", "table7"})
    for (char const* simulator : {"EDEM", "LIGGGHTS"})
      for (char const* column : {"max_force [N]", "porosity [%]", "shape_quality [1]"}) {
        SCOPED_TRACE(fmt::format("{} {} {}", table, simulator, column));
        auto const data = study_seed::observations(table, simulator, column);
        compare_with_r(data, quadratic_terms(static_cast<int>(data.coded.cols())),
                       fmt::format("{} {} {}", table, simulator, data.response_name));
      }
}

// Not orthogonal, with some runs twice and three times: each kind of sum is another number.
TEST(StudyAgainstR, AgreesOnAnUnbalancedDesignWithReplicates) {
  study_support::Noise noise(20200104);
  Eigen::MatrixXd const spread = latin_hypercube(3, 15, 9);
  Eigen::MatrixXd coded(21, 3);
  coded << spread, spread.row(2), spread.row(2), spread.row(5), spread.row(7), spread.row(7),
      spread.row(11);
  VectorXd const y = 40.0 + 6.0 * coded.col(0).array() - 3.0 * coded.col(1).array() +
                     2.0 * coded.col(0).array() * coded.col(2).array() +
                     1.5 * coded.col(1).array().square() + 0.8 * noise.vector(21).array();
  auto const data = study_support::observed(coded, y);
  compare_with_r(data, quadratic_terms(3), "quadratic");
  compare_with_r(data, interaction_terms(3), "interactions");
  compare_with_r(data, linear_terms(3), "linear");
  compare_with_r(data, {{0}, {1}, {2}, {0, 2}, {1, 1}}, "chosen terms");
}
