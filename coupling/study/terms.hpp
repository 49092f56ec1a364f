#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace coupling::study {

/// A term of a polynomial: the product of the factors with these indices, in ascending order.
/// {} is the intercept, {0} the first factor, {0, 0} its square, {0, 1} an interaction.
using Term = std::vector<int>;

enum class TermGroup { intercept, linear, square, interaction };

TermGroup group_of(Term const& term);
char const* name_of(TermGroup group);

/// "E", "E^2", "E*CED", "intercept".
std::string name_of(Term const& term, std::vector<std::string> const& factor_names);

/// x_f; then also x_f x_g; then also x_f^2. None holds the intercept: every model has one.
std::vector<Term> linear_terms(int n_factors);
std::vector<Term> interaction_terms(int n_factors);
std::vector<Term> quadratic_terms(int n_factors);

/// Adds the linear parts that squares and interactions lack, and sorts linear, interaction, square.
std::vector<Term> hierarchical(std::vector<Term> terms);

double value_of(Term const& term, Eigen::VectorXd const& coded);

/// d term / d x_factor.
double slope_of(Term const& term, Eigen::VectorXd const& coded, int factor);

/// Intercept first, then the terms.  [1 + n_terms]
Eigen::VectorXd regressors(std::vector<Term> const& terms, Eigen::VectorXd const& coded);

/// One row a run.  [1], n_runs x (1 + n_terms)
Eigen::MatrixXd model_matrix(std::vector<Term> const& terms, Eigen::MatrixXd const& coded);

} // namespace coupling::study
