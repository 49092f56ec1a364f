#include "coupling/diagnosis/misfit_tests.hpp"

#include "coupling/diagnosis/cell_statistics.hpp"
#include "coupling/diagnosis/normal_draws.hpp"
#include "coupling/study/screening.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int fewest_draws = 400;
constexpr double is_visible = 2.0; // a contrast that deserves a word

std::vector<double> as_vector(VectorXd const& values) {
  return {values.data(), values.data() + values.size()};
}

std::pair<double, int> largest_score(SignatureLibrary const& library, VectorXd const& residual) {
  std::pair<double, int> best{-no_bound, -1};
  for (std::size_t j = 0; j < library.signatures.size(); ++j)
    if (double const score = score_of(library.signatures[j], residual).value; score > best.first)
      best = {score, static_cast<int>(j)};
  return best;
}

std::string shape_in_words(VectorXd const& contrasts) {
  Index largest = 0;
  if (contrasts.cwiseAbs().maxCoeff(&largest) < is_visible)
    return "no trend: it goes up and down";
  bool const is_above = contrasts[largest] > 0.0;
  switch (largest) {
  case 0:
    return is_above ? "measured is above the model" : "measured is below the model";
  case 1:
    return is_above ? "measured rises against the model" : "measured falls against the model";
  default:
    return is_above ? "measured is above the model at both ends of the phase, against its middle"
                    : "measured is above the model in the middle of the phase, against its ends";
  }
}

/// All tests of the map, with their observed values in column 0 and the draws behind it.
struct Map {
  std::vector<Cell> cells;
  std::vector<CellStatistics> statistics;
  std::vector<std::vector<double>> p; ///< one a cell and test, raw, then after Holm
};

Map tested(Observations const& observations, MatrixXd const& covariance, MatrixXd const& residuals,
           std::vector<Cell> cells, auto const& statistics_of) {
  Map map{std::move(cells), {}, {}};
  for (auto const& cell : map.cells) {
    map.statistics.push_back(statistics_of(observations, cell, covariance, residuals));
    auto const& values = map.statistics.back().values;
    std::vector<double> p;
    for (Index k = 0; k < values.rows(); ++k)
      p.push_back(Reference(as_vector(values.row(k).tail(values.cols() - 1).transpose()))
                      .tail_p(values(k, 0)));
    map.p.push_back(p);
  }
  return map;
}

/// Holm's adjustment over the tests of both maps together.
void adjust(Map& by_phase, Map& by_run) {
  std::vector<double> all;
  for (auto const* map : {&by_phase, &by_run})
    for (auto const& p : map->p)
      all.insert(all.end(), p.begin(), p.end());
  auto const adjusted = study::adjust_holm(all);
  auto next = adjusted.begin();
  for (auto* map : {&by_phase, &by_run})
    for (auto& p : map->p)
      for (double& one : p)
        one = *next++;
}

CellMisfit cell_misfit(Observations const& observations, Map const& map, std::size_t cell) {
  auto const& block = observations.blocks()[map.cells[cell].blocks.front()];
  auto const& p = map.p[cell];
  auto const least = std::ranges::min_element(p) - p.begin();
  VectorXd const contrasts = map.statistics[cell].contrasts.col(0);
  Index largest = 0;
  contrasts.cwiseAbs().maxCoeff(&largest);
  return {.channel = block.channel,
          .phase = block.phase,
          .size = contrasts[largest],
          .p_holm = p[static_cast<std::size_t>(least)],
          .test = map.statistics[cell].names[static_cast<std::size_t>(least)],
          .shape = shape_in_words(contrasts)};
}

} // namespace

MisfitTests test_misfit(Observations const& observations, Comparison const& comparison,
                        MatrixXd const& covariance, SignatureLibrary const& library,
                        MisfitSettings const& settings) {
  VALIDATE(settings.n_draws >= fewest_draws,
           fmt::format("misfit: {} draws are too few for a level of {:g} (at least {}). Is speed "
                       "short?",
                       settings.n_draws, settings.level, fewest_draws));
  VALIDATE(
      settings.level > 0.0 && settings.level < 1.0,
      fmt::format("misfit: the level {:g} is no probability. Is it in per cent?", settings.level));
  auto const n = observations.size();
  MatrixXd all(library.tangent.n_extended(), settings.n_draws + 1);
  all.col(0) = library.residual;
  all.rightCols(settings.n_draws) = library.tangent.project_extended(
      normal_draws(settings.seed, library.tangent.n_extended(), settings.n_draws));

  MisfitTests tests{};
  VectorXd const omnibus = all.topRows(n).colwise().squaredNorm();
  VectorXd targeted(all.cols());
  for (Index k = 0; k < all.cols(); ++k)
    targeted[k] = largest_score(library, all.col(k)).first;
  tests.best_mechanism = largest_score(library, all.col(0)).second;
  Reference const of_omnibus(as_vector(omnibus.tail(settings.n_draws)));
  tests.omnibus = omnibus[0];
  tests.p_omnibus = of_omnibus.p(tests.omnibus);
  tests.expected = of_omnibus.mean();
  tests.expected_sd = of_omnibus.sd();
  tests.targeted = targeted[0];
  tests.p_targeted = library.signatures.empty()
                         ? 1.0
                         : Reference(as_vector(targeted.tail(settings.n_draws))).p(targeted[0]);
  tests.is_alarm = std::min(tests.p_omnibus, tests.p_targeted) < 0.5 * settings.level;

  MatrixXd const residuals = comparison.whitener.unwhiten(all.topRows(n));
  auto by_phase =
      tested(observations, covariance, residuals, cells_by_phase(observations), cell_statistics);
  auto by_run =
      tested(observations, covariance, residuals, cells_by_run(observations), level_statistics);
  adjust(by_phase, by_run);
  for (std::size_t c = 0; c < by_phase.cells.size(); ++c)
    tests.cells.push_back(cell_misfit(observations, by_phase, c));
  for (std::size_t c = 0; c < by_run.cells.size(); ++c) {
    auto const& block = observations.blocks()[by_run.cells[c].blocks.front()];
    tests.offsets.push_back(
        {block.run, block.channel, by_run.statistics[c].contrasts(0, 0), by_run.p[c].front()});
  }
  return tests;
}

} // namespace coupling::diagnosis
