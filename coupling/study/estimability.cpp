#include "coupling/study/estimability.hpp"

#include "coupling/study/replicates.hpp"
#include "dem/expect.hpp"

#include <Eigen/QR>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

using Eigen::Index;

constexpr double same = 1e-9; // what coded values and directions may differ by and still be equal

std::string title(Observations const& data) {
  return "response surface of " + data.response_name;
}

std::string const& name_of_factor(Observations const& data, Index f) {
  return data.factor_names[static_cast<std::size_t>(f)];
}

void validate_values(Observations const& data) {
  auto const& coded = data.coded;
  VALIDATE(!data.response_name.empty(),
           "response surface: has no response. Which result is meant?");
  VALIDATE(coded.cols() > 0 && coded.cols() == static_cast<Index>(data.factor_names.size()),
           fmt::format("{}: has {} factor{} in {} columns. Is a name missing?", title(data),
                       data.factor_names.size(), data.factor_names.size() == 1 ? "" : "s",
                       coded.cols()));
  VALIDATE(data.response.size() == coded.rows(),
           fmt::format("{}: {} has {} values for {} runs. Is a run's result missing?", title(data),
                       data.response_name, data.response.size(), coded.rows()));
  for (Index run = 0; run < coded.rows(); ++run) {
    for (Index f = 0; f < coded.cols(); ++f)
      VALIDATE(std::isfinite(coded(run, f)),
               fmt::format("{}: run {}: {} = {} (a factor is a number). Was it read?", title(data),
                           run + 1, name_of_factor(data, f), coded(run, f)));
    VALIDATE(std::isfinite(data.response[run]),
             fmt::format("{}: run {}: {} = {} (a run without a result cannot be fitted). Leave the "
                         "run out?",
                         title(data), run + 1, data.response_name, data.response[run]));
  }
}

void validate_terms(Observations const& data, std::vector<Term> const& terms) {
  for (auto const& term : terms) {
    bool const is_known = !term.empty() && term.size() <= 2 && std::ranges::is_sorted(term) &&
                          term.front() >= 0 && term.back() < data.coded.cols();
    VALIDATE(is_known,
             fmt::format("{}: a term has the factors [{}] (one or two of 0 to {}, in ascending "
                         "order). Which is meant?",
                         title(data), fmt::join(term, ", "), data.coded.cols() - 1));
    VALIDATE(std::ranges::count(terms, term) == 1,
             fmt::format("{}: {} is there twice. Leave one out?", title(data),
                         name_of(term, data.factor_names)));
    for (int const f : term)
      VALIDATE(
          term.size() == 1 || std::ranges::count(terms, Term{f}) == 1,
          fmt::format("{}: {} stands without {} (its meaning would hang on where the coded zero "
                      "is). Add {}?",
                      title(data), name_of(term, data.factor_names), name_of_factor(data, f),
                      name_of_factor(data, f)));
  }
}

void validate_factors_vary(Observations const& data) {
  for (Index f = 0; f < data.coded.cols(); ++f) {
    auto const column = data.coded.col(f);
    VALIDATE(column.maxCoeff() - column.minCoeff() > same,
             fmt::format("{}: {} = {:.6g} (coded) in all {} runs (its effect cannot be seen). Vary "
                         "it, or leave it out?",
                         title(data), name_of_factor(data, f), column[0], column.size()));
  }
}

void validate_factors_part(Observations const& data) {
  Eigen::MatrixXd const centred = data.coded.rowwise() - data.coded.colwise().mean();
  for (Index f = 0; f < centred.cols(); ++f)
    for (Index g = f + 1; g < centred.cols(); ++g) {
      double const slope = centred.col(f).dot(centred.col(g)) / centred.col(f).squaredNorm();
      double const apart = (centred.col(g) - slope * centred.col(f)).norm();
      VALIDATE(apart > same * centred.col(g).norm(),
               fmt::format("{}: {} and {} move together (coded {} = {:.6g} {} {} {:.6g} in all {} "
                           "runs; their effects cannot be told apart). Vary one alone?",
                           title(data), name_of_factor(data, f), name_of_factor(data, g),
                           name_of_factor(data, g), slope, name_of_factor(data, f),
                           data.coded(0, g) - slope * data.coded(0, f) < -same ? "-" : "+",
                           std::abs(data.coded(0, g) - slope * data.coded(0, f)), centred.rows()));
    }
}

void validate_number_of_runs(Observations const& data, std::vector<Term> const& terms) {
  std::vector<std::string> names{"intercept"};
  for (auto const& term : terms)
    names.push_back(name_of(term, data.factor_names));
  auto const needed = static_cast<Index>(names.size());
  VALIDATE(data.coded.rows() >= needed,
           fmt::format("{}: has {} runs for {} terms ({}; each needs a run, and one more to see an "
                       "error). At least {} runs, or fewer terms?",
                       title(data), data.coded.rows(), needed, fmt::join(names, ", "), needed));
  auto const n_points = static_cast<Index>(replicates(data.coded).size());
  VALIDATE(n_points >= needed,
           fmt::format("{}: has {} runs at {} different points for {} terms ({}; each needs a "
                       "point). At least {} points, or fewer terms?",
                       title(data), data.coded.rows(), n_points, needed, fmt::join(names, ", "),
                       needed));
}

/// "1 - E + 0.5 CED" of coefficients that are not zero.
std::string sum_of(Eigen::VectorXd const& coefficients, std::vector<std::string> const& names) {
  std::string text;
  for (Index j = 0; j < coefficients.size(); ++j) {
    double const value = coefficients[j];
    if (std::abs(value) < same)
      continue;
    text += text.empty() ? (value < 0.0 ? "-" : "") : (value < 0.0 ? " - " : " + ");
    bool const is_one = std::abs(std::abs(value) - 1.0) < same;
    if (j == 0 || !is_one)
      text += fmt::format("{:.6g}{}", std::abs(value), j == 0 ? "" : " ");
    if (j > 0)
      text += names[static_cast<std::size_t>(j)];
  }
  return text.empty() ? "0" : text;
}

/// Each column that is a sum of those before it, by name: "E^2 = 1".
std::vector<std::string> aliases(Eigen::MatrixXd const& X, std::vector<std::string> const& names) {
  std::vector<std::string> found, kept_names;
  Eigen::MatrixXd kept(X.rows(), 0);
  for (Index j = 0; j < X.cols(); ++j) {
    Eigen::VectorXd const column = X.col(j);
    auto const& name = names[static_cast<std::size_t>(j)];
    if (kept.cols() > 0) {
      Eigen::VectorXd const b = kept.colPivHouseholderQr().solve(column);
      if ((column - kept * b).norm() <= same * column.norm()) {
        found.push_back(name + " = " + sum_of(b, kept_names));
        continue;
      }
    }
    kept.conservativeResize(Eigen::NoChange, kept.cols() + 1);
    kept.rightCols(1) = column;
    kept_names.push_back(name);
  }
  return found;
}

void validate_no_aliases(Observations const& data, std::vector<Term> const& terms) {
  std::vector<std::string> names{"intercept"};
  for (auto const& term : terms)
    names.push_back(name_of(term, data.factor_names));
  auto const found = aliases(model_matrix(terms, data.coded), names);
  VALIDATE(
      found.empty(),
      fmt::format("{}: {} in all {} runs (such terms cannot be told apart; a square needs three "
                  "levels of its factor). Add runs that part them, or leave {} out?",
                  title(data), fmt::join(found, ", "), data.coded.rows(),
                  found.size() == 1 ? "it" : "them"));
}

} // namespace

void validate_estimable(Observations const& data, std::vector<Term> const& terms) {
  validate_values(data);
  validate_terms(data, terms);
  VALIDATE(
      data.coded.rows() > 0,
      fmt::format("{}: has no runs (there is nothing to fit). Which runs are meant?", title(data)));
  validate_factors_vary(data);
  validate_factors_part(data);
  validate_number_of_runs(data, terms);
  validate_no_aliases(data, terms);
}

} // namespace coupling::study
