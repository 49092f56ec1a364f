#pragma once

#include "coupling/study/least_squares.hpp"
#include "coupling/study/terms.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace coupling::study {

/// Runs of a design and one of their results.
struct Observations {
  std::vector<std::string> factor_names; ///< one a column of `coded`
  Eigen::MatrixXd coded;                 ///< [1], n_runs x n_factors
  std::string response_name;             ///< "max_force"
  Eigen::VectorXd response;              ///< [unit of the response], n_runs
};

struct Coefficient {
  std::string name; ///< "intercept", "E", "E*CED", "E^2"
  TermGroup group;
  double value; ///< [unit of the response], in coded units
  double standard_error;
  double t;            ///< value / standard_error
  double p;            ///< two-sided, Student's t
  double lower, upper; ///< 95 % confidence interval
};

/// What the surface says at one point. Standard deviations and intervals are NaN where no degree of
/// freedom is left.
struct SurfacePrediction {
  double value;                  ///< y(x) = z(x)^T b
  double mean_sd;                ///< s sqrt(z^T (X^T X)^-1 z): of the surface itself
  double run_sd;                 ///< s sqrt(1 + z^T (X^T X)^-1 z): of a new run
  double mean_lower, mean_upper; ///< confidence interval of the surface
  double run_lower, run_upper;   ///< prediction interval of a new run
};

/// A polynomial of the coded factors, fitted by least squares.
/// Source: Montgomery, Peck, Vining, Introduction to Linear Regression Analysis, 5th ed. (2012),
/// sections 3.2 to 3.5; Myers, Montgomery, Anderson-Cook (2016), section 2.
struct ResponseSurface {
  Observations data;
  std::vector<Term> terms; ///< without the intercept
  LeastSquares fit;        ///< columns: intercept, terms
  double total_ss;         ///< sum of (y - mean y)^2

  std::vector<Coefficient> coefficients() const;
  double r_squared() const;           ///< 1 - RSS / TSS; NaN for a response that does not vary
  double adjusted_r_squared() const;  ///< 1 - (RSS / df) / (TSS / (n - 1))
  double predicted_r_squared() const; ///< 1 - PRESS / TSS

  /// @param coded  [1], n_factors
  double value(Eigen::VectorXd const& coded) const;
  /// d y / d x_f, [unit of the response]
  Eigen::VectorXd gradient(Eigen::VectorXd const& coded) const;
  SurfacePrediction predict(Eigen::VectorXd const& coded, double confidence = 0.95) const;

  int n_runs() const { return static_cast<int>(data.coded.rows()); }
  int n_factors() const { return static_cast<int>(data.coded.cols()); }
};

/// @param terms  hierarchical, without the intercept, each of degree 1 or 2; e.g.
/// quadratic_terms(k)
/// @throws dem::InvalidInput if the runs do not determine the terms, saying which and why
/// (estimability.hpp)
ResponseSurface fit_response_surface(Observations data, std::vector<Term> terms);

} // namespace coupling::study
