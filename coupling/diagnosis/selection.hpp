#pragma once

#include "coupling/diagnosis/evidence.hpp"
#include "coupling/diagnosis/misfit_tests.hpp"

#include <array>

namespace coupling::diagnosis {

struct SelectionSettings {
  int n_screened = 6;       ///< singles that are refitted, the best by score; all if chi^2 is huge
  double huge_share = 2.0;  ///< chi^2 over its expectation from which all singles are refitted
  int n_bases = 3;          ///< best singles that pairs are built on
  int n_partners = 6;       ///< partners that each base is given, the best by score after it
  double failing_sds = 4.0; ///< chi^2 above its expectation from which a hypothesis has failed
  std::array<double, 4> prior_shares{0.5, 0.4, 0.1, 0.02}; ///< of none, all singles, pairs, triples
};

/// One set of causes, refitted.
struct Hypothesis {
  Fit fit;
  double log_evidence;
  double log_prior;   ///< ln of its share: prior_shares[k] over the number of sets of k
  double probability; ///< exp(log_evidence / S + log_prior), normalised over all that were fitted
};

struct Selection {
  std::vector<Hypothesis> hypotheses; ///< the most probable first; none is always among them
  double tempering;                   ///< S = max(1, least chi^2 / its expectation)
  Eigen::VectorXd inclusion; ///< p_j = sum of P(M | data, not none) over M with j, [n_mechanisms]
  double probability_of_none;

  Hypothesis const& best() const { return hypotheses.front(); }
};

/// Searches the sets of causes under one common Sigma: none, singles (screened by score, then
/// refitted), pairs on the best singles, what the best pairs leave without one of their causes,
/// other partners for both of the best pair, triples on the best pair if all pairs have failed.
/// @param expected  of chi^2 when nothing is wrong, and its standard deviation
Selection select_causes(Comparison const& comparison, Fit const& baseline,
                        SignatureLibrary const& library, double expected, double expected_sd,
                        SelectionSettings const& settings);

/// Probabilities anew, for other evidences or after hypotheses were taken out.
void weigh(Selection& selection, double expected, SelectionSettings const& settings,
           Eigen::Index n_mechanisms);

/// Where a search for a hypothesis begins: the calibrated parameters and sizes of an already fitted
/// subset, one more mechanism at its size by score (a tenth of its scale if that is 0).
Fit refit_with(Comparison const& comparison, Fit const& subset, SignatureLibrary const& library,
               int added);

} // namespace coupling::diagnosis
