#include "coupling/study/terms.hpp"

#include <algorithm>
#include <tuple>

namespace coupling::study {

TermGroup group_of(Term const& term) {
  if (term.empty())
    return TermGroup::intercept;
  if (term.size() == 1)
    return TermGroup::linear;
  return term.front() == term.back() ? TermGroup::square : TermGroup::interaction;
}

char const* name_of(TermGroup group) {
  switch (group) {
  case TermGroup::intercept:
    return "intercept";
  case TermGroup::linear:
    return "linear";
  case TermGroup::square:
    return "square";
  case TermGroup::interaction:
    return "interaction";
  }
  return "";
}

std::string name_of(Term const& term, std::vector<std::string> const& factor_names) {
  auto const factor = [&](std::size_t k) {
    return factor_names.at(static_cast<std::size_t>(term[k]));
  };
  switch (group_of(term)) {
  case TermGroup::intercept:
    return "intercept";
  case TermGroup::linear:
    return factor(0);
  case TermGroup::square:
    return factor(0) + "^2";
  case TermGroup::interaction:
    return factor(0) + "*" + factor(1);
  }
  return "";
}

std::vector<Term> linear_terms(int n_factors) {
  std::vector<Term> terms;
  terms.reserve(static_cast<std::size_t>(n_factors));
  for (int f = 0; f < n_factors; ++f)
    terms.push_back({f});
  return terms;
}

std::vector<Term> interaction_terms(int n_factors) {
  auto terms = linear_terms(n_factors);
  for (int f = 0; f < n_factors; ++f)
    for (int g = f + 1; g < n_factors; ++g)
      terms.push_back({f, g});
  return terms;
}

std::vector<Term> quadratic_terms(int n_factors) {
  auto terms = interaction_terms(n_factors);
  for (int f = 0; f < n_factors; ++f)
    terms.push_back({f, f});
  return terms;
}

std::vector<Term> hierarchical(std::vector<Term> terms) {
  for (std::size_t t = terms.size(); t-- > 0;)
    if (terms[t].size() > 1)
      for (int const f : Term(terms[t]))
        terms.push_back({f});
  auto const rank = [](Term const& term) {
    return std::tuple(term.size(), group_of(term) == TermGroup::square, term);
  };
  std::ranges::sort(terms, {}, rank);
  // std::ranges::unique is beyond clang 14.
  terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
  return terms;
}

double value_of(Term const& term, Eigen::VectorXd const& coded) {
  double product = 1.0;
  for (int const f : term)
    product *= coded[f];
  return product;
}

double slope_of(Term const& term, Eigen::VectorXd const& coded, int factor) {
  double slope = 0.0; // product rule: leave out each occurrence in turn
  for (std::size_t out = 0; out < term.size(); ++out)
    if (term[out] == factor) {
      double rest = 1.0;
      for (std::size_t k = 0; k < term.size(); ++k)
        rest *= k == out ? 1.0 : coded[term[k]];
      slope += rest;
    }
  return slope;
}

Eigen::VectorXd regressors(std::vector<Term> const& terms, Eigen::VectorXd const& coded) {
  Eigen::VectorXd z(1 + static_cast<Eigen::Index>(terms.size()));
  z[0] = 1.0;
  for (std::size_t t = 0; t < terms.size(); ++t)
    z[1 + static_cast<Eigen::Index>(t)] = value_of(terms[t], coded);
  return z;
}

Eigen::MatrixXd model_matrix(std::vector<Term> const& terms, Eigen::MatrixXd const& coded) {
  Eigen::MatrixXd X(coded.rows(), 1 + static_cast<Eigen::Index>(terms.size()));
  for (Eigen::Index run = 0; run < coded.rows(); ++run)
    X.row(run) = regressors(terms, coded.row(run));
  return X;
}

} // namespace coupling::study
