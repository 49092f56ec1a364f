#include "coupling/verification/verify.hpp"

#include "coupling/verification/benchmarks.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace coupling::verification {
namespace {

bool matches(std::string_view name, std::string_view filter) {
  return name.find(filter) != std::string_view::npos;
}

std::vector<Benchmark> run_one(Experiment const& experiment) {
  try {
    return experiment.run();
  } catch (std::exception const& failure) {
    double const nan = std::nan("");
    return {{experiment.name, nan, nan, nan, 0.0, false,
             std::string("did not run: ") + failure.what()}};
  }
}

} // namespace

std::vector<Experiment> all_experiments() {
  std::vector<Experiment> all;
  for (auto const theme :
       {collision_experiments, adhesion_experiments, friction_experiments, integrator_experiments,
        particle_impact_experiments, press_motion_experiments, study_experiments,
        elasticity_experiments, coupled_experiments}) {
    std::ranges::move(theme(), std::back_inserter(all));
  }
  return all;
}

Benchmark compare(std::string name, double reference, double result, double tolerance,
                  std::string source) {
  double const scale = reference == 0.0 ? 1.0 : std::abs(reference);
  double const error = std::abs(result - reference) / scale;
  return {std::move(name), reference,          result,           error,
          tolerance,       error <= tolerance, std::move(source)};
}

std::vector<Experiment> experiments_for(std::string_view filter) {
  auto experiments = all_experiments();
  auto const is_named = [&](Experiment const& one) {
    return matches(one.name, filter) || filter.starts_with(one.name + "/");
  };
  bool const names_one = std::ranges::any_of(experiments, is_named);
  std::erase_if(experiments, [&](Experiment const& one) {
    bool const is_theme = filter.starts_with(one.name.substr(0, one.name.find('/')));
    return !is_named(one) && (names_one || !is_theme);
  });
  return experiments;
}

std::vector<Benchmark> run_benchmarks(std::string_view filter) {
  std::vector<Benchmark> rows;
  for (Experiment const& experiment : experiments_for(filter)) {
    bool const whole = matches(experiment.name, filter);
    for (Benchmark& row : run_one(experiment)) {
      if (whole || matches(row.name, filter))
        rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::string to_text(std::vector<Benchmark> const& rows) {
  std::size_t width = 9;
  for (Benchmark const& row : rows)
    width = std::max(width, row.name.size());
  std::string text = fmt::format("{:<{}}  {:>14}  {:>14}  {:>9}  {:>9}\n", "benchmark", width,
                                 "reference", "result", "error", "tolerance");
  for (Benchmark const& row : rows) {
    text +=
        fmt::format("{:<{}}  {:>14.7g}  {:>14.7g}  {:>9.2g}  {:>9.2g}  {}\n", row.name, width,
                    row.reference, row.result, row.error, row.tolerance, row.ok ? "ok" : "FAILED");
    if (std::isnan(row.result))
      text += "  " + row.source + "\n";
  }
  auto const failed = std::ranges::count_if(rows, [](Benchmark const& row) { return !row.ok; });
  return text + fmt::format("{} benchmarks, {} failed\n", rows.size(), failed);
}

int run_verification(VerifyOptions const& options) {
  std::vector<Benchmark> const rows = run_benchmarks(options.filter);
  VALIDATE(!rows.empty(),
           fmt::format("--filter {}: no benchmark has this in its name. Run `presscheck verify` "
                       "without it to see the names?",
                       options.filter));
  std::fputs(to_text(rows).c_str(), stdout);
  write_json(rows, options.folder / "verification.json");
  write_html(rows, options.folder / "verification.html");
  return std::ranges::all_of(rows, &Benchmark::ok) ? 0 : 1;
}

} // namespace coupling::verification
