#include "coupling/finding/power_table.hpp"

#include "coupling/reduced/error_sources.hpp"

#include <fmt/format.h>

namespace coupling::finding {
namespace {

PowerColumn column_of(PowerQuestion const& question, reduced::InstrumentSet const& set,
                      PowerTable& table) {
  auto const rows = planned_rows(question.nominal, set, question.instruments, question.fill_height);
  reduced::PressModel const model(question.nominal, question.simulated.sheet,
                                  repeat_scatter(question.simulated, rows.channels), rows.plan);
  auto const errors = error_sources(model, rows.channels, question.simulated.fit,
                                    uncertainty_of(question.simulated));
  table.calibrated = model.calibrated();
  table.scatters = model.scatters();
  table.tolerances.clear();
  for (auto const& one : diagnosis::state(errors.tolerances))
    table.tolerances.push_back({.name = one.name,
                                .value = one.value,
                                .unit = "1",
                                .meaning = one.meaning,
                                .source = one.source});
  return {.set = set,
          .n_rows = rows.plan.n_rows(),
          .causes =
              power_of(diagnosis::Observations(rows.blocks), model, errors, question.settings)};
}

/// The emulator, and how its packings and those of the laboratory scatter.
std::string in_words(reduced::SimulatedPress const& simulated) {
  auto const packings = simulated.n_packings == 1
                            ? std::string("one packing")
                            : fmt::format("{} packings", simulated.n_packings);
  return in_words(simulated.fit) +
         (simulated.n_grains == 0
              ? fmt::format("; {} of an unknown number of grains", packings)
              : fmt::format("; {}, scattering as {} grains do", packings, simulated.n_grains));
}

} // namespace

PowerTable power_table(PowerQuestion const& question,
                       std::vector<reduced::InstrumentSet> const& sets) {
  PowerTable table{.provenance = {},
                   .emulator = in_words(question.simulated),
                   .instruments = question.instruments,
                   .settings = question.settings,
                   .calibrated = {},
                   .scatters = {},
                   .tolerances = {},
                   .columns = {}};
  for (auto const& set : sets)
    table.columns.push_back(column_of(question, set, table));
  return table;
}

} // namespace coupling::finding
