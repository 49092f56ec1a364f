#include "coupling/finding/power_table.hpp"

#include "coupling/reduced/error_sources.hpp"

namespace coupling::finding {
namespace {

PowerColumn column_of(PowerQuestion const& question, reduced::InstrumentSet const& set,
                      PowerTable& table) {
  auto const rows = planned_rows(question.nominal, set, question.instruments, question.fill_height);
  reduced::PressModel const model(question.nominal, question.simulated.sheet, {}, rows.plan);
  auto const errors = error_sources(model, rows.channels, question.simulated.fit);
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

} // namespace

PowerTable power_table(PowerQuestion const& question,
                       std::vector<reduced::InstrumentSet> const& sets) {
  PowerTable table{.provenance = {},
                   .emulator = in_words(question.simulated.fit),
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
