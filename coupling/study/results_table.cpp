#include "coupling/study/results_table.hpp"

#include "coupling/record/atomic_file.hpp"
#include "coupling/record/csv.hpp"
#include "coupling/study/batch.hpp"
#include "coupling/study/results_data.hpp"
#include "coupling/study/study_json.hpp"
#include "coupling/study/validation_runs.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace coupling::study {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::vector<std::size_t> rows_that(ResultsTable const& table, bool are_validation) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < table.rows.size(); ++k)
    if (table.rows[k].is_done() && table.rows[k].run.is_validation == are_validation)
      found.push_back(k);
  return found;
}

Eigen::MatrixXd of_factors(ResultsTable const& table, bool is_coded) {
  auto const rows = table.finished();
  auto const& factors = table.study.factors;
  Eigen::MatrixXd values(rows.size(), factors.size());
  for (Eigen::Index r = 0; r < values.rows(); ++r)
    for (Eigen::Index f = 0; f < values.cols(); ++f) {
      auto const& factor = factors[static_cast<std::size_t>(f)];
      double const natural =
          table.rows[rows[static_cast<std::size_t>(r)]].run.natural[static_cast<std::size_t>(f)];
      values(r, f) = is_coded ? factor.coded(natural) : natural;
    }
  return values;
}

/// Header and cells of results.csv.
std::string join(std::vector<std::string> const& cells) {
  std::string line;
  for (auto const& cell : cells)
    line += (line.empty() ? "" : ",") + csv_field(cell);
  return line + "\n";
}

std::vector<std::string> cells_of(ResultsTable const& table, ResultRow const& row,
                                  std::set<std::string> const& quantities) {
  std::vector<std::string> cells{row.run.id, row.run.setup, fmt::format("{}", row.run.replicate),
                                 row.run.is_validation ? "validation" : "design", word(row.state)};
  auto const& factors = table.study.factors;
  for (std::size_t f = 0; f < factors.size(); ++f) {
    cells.push_back(shortest(row.run.natural[f]));
    cells.push_back(shortest(factors[f].coded(row.run.natural[f])));
  }
  for (auto const& quantity : quantities)
    cells.push_back(shortest(row.value(quantity)));
  cells.push_back(shortest(row.cpu_seconds > 0.0 ? row.cpu_seconds : unknown));
  return cells;
}

} // namespace

double ResultRow::value(std::string const& quantity) const {
  auto const found = values.find(quantity);
  return found == values.end() ? unknown : found->second.value;
}

std::vector<std::size_t> ResultsTable::finished() const {
  return rows_that(*this, false);
}

std::vector<std::size_t> ResultsTable::validation() const {
  return rows_that(*this, true);
}

Eigen::MatrixXd ResultsTable::natural() const {
  return of_factors(*this, false);
}

Eigen::MatrixXd ResultsTable::coded() const {
  return of_factors(*this, true);
}

Eigen::VectorXd ResultsTable::response(StudyResponse const& response) const {
  auto const finished_rows = finished();
  Eigen::VectorXd values(finished_rows.size());
  for (Eigen::Index r = 0; r < values.size(); ++r) {
    auto const& row = rows[finished_rows[static_cast<std::size_t>(r)]];
    values(r) = row.value(response.quantity);
    VALIDATE(!std::isnan(values(r)),
             fmt::format("{}: Quantity = {}: run '{}' does not have it (its cycle never came so "
                         "far). Another response, or another programme?",
                         response.where, response.quantity, row.run.id));
  }
  return values;
}

std::vector<int> ResultsTable::replicates() const {
  std::vector<int> numbers;
  for (auto const k : finished())
    numbers.push_back(rows[k].run.replicate);
  return numbers;
}

Eigen::VectorXd ResultsTable::cpu_seconds() const {
  auto const finished_rows = finished();
  Eigen::VectorXd seconds(finished_rows.size());
  for (Eigen::Index r = 0; r < seconds.size(); ++r) {
    double const own = rows[finished_rows[static_cast<std::size_t>(r)]].cpu_seconds;
    seconds(r) = own > 0.0 ? own : unknown;
  }
  return seconds;
}

ResultsTable results_as_data(StudyPlan const& plan) {
  ResultsTable table{plan.study, {}};
  auto const values = read_results(plan);
  for (std::size_t k = 0; k < plan.runs.size(); ++k) {
    ResultRow row{.run = plan.runs[k],
                  .state = RunState::done,
                  .reason = {},
                  .folder = {},
                  .values = values[k],
                  .estimate = {}};
    if (auto const cpu = values[k].find("cpu_seconds"); cpu != values[k].end())
      row.cpu_seconds = cpu->second.value;
    table.rows.push_back(std::move(row));
  }
  return table;
}

ResultsTable results_of(StudyPlan const& plan, std::vector<StudyRun> const& runs,
                        std::vector<RunEstimate> const& estimates, BatchFolder const& folder) {
  ResultsTable table{plan.study, {}};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    auto const record = folder.record(runs[k]);
    ResultRow row{.run = runs[k],
                  .state = record.state,
                  .reason = record.reason,
                  .folder = folder.run(runs[k].id),
                  .values = {},
                  .estimate = estimates[k],
                  .cpu_seconds = record.cpu_seconds,
                  .wall_seconds = record.wall_seconds};
    if (row.state != RunState::done && folder.is_locked(runs[k].id))
      row.state = RunState::running;
    if (row.is_done())
      row.values = values_of_summary(row.folder / "summary.json");
    table.rows.push_back(std::move(row));
  }
  return table;
}

ResultsTable load_study(std::filesystem::path const& place) {
  BatchFolder const folder(place);
  auto const file = folder.path() / "study.resolved.prm";
  VALIDATE(std::filesystem::exists(file),
           fmt::format("{}: holds no study (it has no study.resolved.prm). Is it the right folder?",
                       place.string()));
  auto const plan = plan_study(read_study(file));
  if (plan.study.is_data())
    return results_as_data(plan);
  auto runs = plan.runs;
  for (auto& run : kept_validation_runs(plan, folder))
    runs.push_back(std::move(run));
  std::vector<RunEstimate> estimates;
  for (auto const& kept : folder.kept_estimates(runs))
    estimates.push_back(kept.value_or(RunEstimate{}));
  return results_of(plan, runs, estimates, folder);
}

std::string results_csv(ResultsTable const& table) {
  std::map<std::string, std::string> units;
  for (auto const& row : table.rows)
    for (auto const& [name, value] : row.values)
      if (name != "cpu_seconds" && table.study.factor(name) == nullptr)
        units[name] = value.unit;
  std::vector<std::string> header{"run", "setup", "replicate", "role", "status"};
  for (auto const& factor : table.study.factors) {
    header.push_back(fmt::format("{} [{}]", factor.name, factor.si_unit()));
    header.push_back(fmt::format("{}_coded [1]", factor.name));
  }
  std::set<std::string> quantities;
  for (auto const& [name, unit] : units) {
    header.push_back(fmt::format("{} [{}]", name, unit));
    quantities.insert(name);
  }
  header.emplace_back("cpu_seconds [s]");
  auto text = join(header);
  for (auto const& row : table.rows)
    text += join(cells_of(table, row, quantities));
  return text;
}

void write_results(ResultsTable const& table, std::filesystem::path const& folder) {
  write_file(folder / "results.csv", results_csv(table));
  write_file(folder / "study.json", study_json(table));
}

} // namespace coupling::study
