#pragma once

#include "coupling/study/power_law.hpp"
#include "coupling/study/results_table.hpp"

#include <optional>
#include <string>
#include <vector>

namespace coupling::study {

/// What a run that has not been made would need.
struct CostForecast {
  double at;              ///< the factor [SI], or the number of grains
  CostPrediction seconds; ///< of one processor; intervals are NaN where two runs alone fix the law
  CostPrediction grains;  ///< by their own power law; NaN where the runs do not tell
  double bytes;           ///< 200 MB + 1000 B a grain (run_cost.hpp): an allowance, not measured
  double bytes_upper;     ///< at the upper end of the grains' prediction interval
};

/// Processor time and grains of the finished runs as power laws of a factor.
struct CostAnalysis {
  std::string factor;
  std::vector<double> sizes, seconds; ///< of the runs that tell their time, one a run
  std::optional<PowerLaw> law;        ///< of the time; none where the runs do not determine one
  std::optional<PowerLaw> grains;     ///< none where they do not tell, or are the factor
  std::vector<CostForecast> forecasts;
  std::vector<std::string> statements; ///< what a reader must know, a sentence each
};

/// @param table  whose study has a Cost/Factor
CostAnalysis analyse_cost(ResultsTable const& table);

} // namespace coupling::study
