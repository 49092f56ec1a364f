#pragma once

#include "coupling/case.hpp"
#include "coupling/elastic/tool_coupling.hpp"
#include "coupling/peak_state.hpp"
#include "coupling/press_programme.hpp"
#include "coupling/press_tally.hpp"
#include "coupling/record/press_record.hpp"
#include "dem/expect.hpp"
#include "dem/step/visit_state.hpp"
#include "dem/step/world.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace coupling {

/// Everything of a press cycle: what was asked for, the grains and tools, the programme and what
/// has been recorded.
struct Press {
  Case setup;
  dem::World world;
  PressProgramme programme;
  PressRecord record;
  PressTally tally;
  LoadCell load_cell;
  PeakState peak;
  ToolCoupling coupling; ///< of grains and deformable tools; rigid ones need none
  double grain_mass =
      0.0; ///< [kg], of all grains; kept, because a sum in another order is another number

  /// Calls `write(name, value)` for all that a restart must restore; what the case rebuilds is left
  /// out.
  template <class Writer> void save(Writer&& write);

  /// Takes everything back by `read(name, value)`, in the order of `save`.
  /// @throws dem::InvalidInput if it does not belong to this case
  template <class Reader> void load(Reader&& read);
};

/// Shows a record as three flat arrays and takes it back from them: a reader may have changed them.
template <class Field>
void visit_record(PressRecord& record, std::span<Stage const> stages, Field&& field) {
  std::size_t const width = record.columns().size();
  std::vector<std::uint32_t> stage_of_row;
  std::vector<double> values;
  for (auto const& name : record.stages())
    stage_of_row.push_back(
        static_cast<std::uint32_t>(std::ranges::find(stages, name, &Stage::name) - stages.begin()));
  for (auto const& row : record.rows())
    values.insert(values.end(), row.begin(), row.end());
  field("record/stage", stage_of_row);
  field("record/values", values);
  VALIDATE(values.size() == width * stage_of_row.size() &&
               std::ranges::all_of(stage_of_row,
                                   [&](std::uint32_t stage) { return stage < stages.size(); }),
           "restart: its record does not fit the case's stages and columns. Is the file from "
           "another version?");
  PressRecord restored(record.columns());
  for (std::size_t k = 0; k < stage_of_row.size(); ++k) {
    auto const first = values.begin() + static_cast<std::ptrdiff_t>(k * width);
    restored.add_row(stages[stage_of_row[k]].name,
                     {first, first + static_cast<std::ptrdiff_t>(width)});
  }
  record = std::move(restored);
}

template <class Writer> void Press::save(Writer&& write) {
  auto state = dem::capture_state(world);
  dem::visit_state(state, write);
  programme.visit_state(write);
  coupling.visit_state(write);
  visit_record(record, programme.stages(), write);
  tally.visit_state(write);
  load_cell.visit_state(write);
  peak.visit_state(write);
  write("grains/total_mass", grain_mass);
}

template <class Reader> void Press::load(Reader&& read) {
  dem::WorldState state;
  dem::visit_state(state, read);
  dem::restore_state(world, state);
  programme.visit_state(read);
  coupling.visit_state(read);
  coupling.show_courses();
  visit_record(record, programme.stages(), read);
  tally.visit_state(read);
  load_cell.visit_state(read);
  peak.visit_state(read);
  read("grains/total_mass", grain_mass);
}

} // namespace coupling
