#include "coupling/press_output.hpp"

#include "coupling/elastic/tool_stress.hpp"
#include "coupling/grain_fields.hpp"
#include "coupling/press_measures.hpp"
#include "coupling/press_set_up.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/curves.hpp"
#include "coupling/record/restart_file.hpp"
#include "coupling/record/run_file.hpp"
#include "coupling/record/summary_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <omp.h>

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

namespace fs = std::filesystem;

std::string snapshot_name(char const* what, std::uint64_t index, char const* ending) {
  return fmt::format("snapshots/{}_{:04d}.{}", what, index, ending);
}

RestartHeader header_of(Press const& press, std::string const& stage) {
  return {.program_version = PRESSCHECK_VERSION,
          .case_text = press.setup.resolved_text,
          .stage = stage,
          .step = press.world.step,
          .time = press.world.time};
}

void write_state(Press& press, fs::path const& file, std::string const& stage) {
  StateWriter write(file, header_of(press, stage));
  press.save(write);
  write.commit();
}

void write_grains(Press const& press, fs::path const& file, GrainFields const& fields) {
  dem::Spheres const& grains = press.world.grains;
  std::vector<VtuField> const shown{{"velocity [m/s]", grains.velocity},
                                    {"radius [m]", 1, std::span(grains.radius)},
                                    {"component", 1, std::span(grains.material)},
                                    {"id", 1, std::span(grains.id)},
                                    {"mean overlap [m]", 1, std::span(fields.mean_overlap)},
                                    {"pressure [Pa]", 1, std::span(fields.pressure)},
                                    {"contacts", 1, std::span(fields.n_contacts)}};
  write_points_vtu(file, press.world.time, grains.position, shown);
}

void write_tool_surfaces(Press const& press, fs::path const& file, ToolFields const& fields) {
  std::vector<VtuField> const shown{{"tool", 1, std::span(fields.tool)},
                                    {"traction [Pa]", fields.traction}};
  write_triangles_vtu(file, press.world.time, fields.vertices, fields.triangles, shown);
}

} // namespace

RunFolder::RunFolder(fs::path folder, double time)
    : folder_(std::move(folder)), grains_(folder_ / "grains.pvd", time),
      tools_(folder_ / "tools.pvd", time) {}

void RunFolder::write_inputs(Press const& press) const {
  write_file(folder_ / "case.resolved.prm", press.setup.resolved_text);
  write_tools(press, folder_ / "geometry");
}

void RunFolder::write_snapshot(Press& press) {
  if (press.tally.last_snapshot == press.world.time)
    return;
  press.tally.last_snapshot = press.world.time;
  fs::create_directories(folder_ / "snapshots");
  auto const index = grains_.size();
  dem::ContactStream const contacts(press.world);
  auto const grains = snapshot_name("grains", index, "vtu");
  auto const tools = snapshot_name("tools", index, "vtu");
  write_grains(press, folder_ / grains, grain_fields(press.world, contacts));
  write_tool_surfaces(press, folder_ / tools, tool_fields(press.world, contacts));
  auto const& stage = press.record.stages();
  write_grain_frame(folder_ / snapshot_name("grains", index, "h5"), press.world.time,
                    stage.empty() ? "" : stage.back(), press.world.grains);
  grains_.add(press.world.time, grains);
  tools_.add(press.world.time, tools);
}

void RunFolder::write_tool_stresses(Press const& press) const {
  fs::create_directories(folder_ / "snapshots");
  for (std::size_t t = 0; t < press.coupling.n_tools(); ++t) {
    if (!press.world.tools[t].present)
      continue;
    YieldingTool const& tool = press.coupling.tool(t);
    // The time is before this frame's, so that a repeated window replaces what it wrote before.
    PvdSeries frames(folder_ / (tool.name + "_stress.pvd"), std::nextafter(press.world.time, -1.0));
    auto const name = snapshot_name((tool.name + "_stress").c_str(), frames.size(), "vtu");
    write_tool_stress(folder_ / name, tool, press.coupling.last_load(t));
    frames.add(press.world.time, name);
  }
}

fs::path RunFolder::write_restart(Press& press) {
  auto const file = rolling_restart(folder_, press.world.step);
  write_state(press, file, press.programme.is_done() ? "" : press.programme.stage().name);
  prune_restarts(folder_);
  return file;
}

fs::path RunFolder::write_stage_restart(Press& press, std::string const& stage) {
  auto const file = stage_restart(folder_, stage);
  write_state(press, file, stage);
  return file;
}

void RunFolder::write_curves(Press const& press) const {
  coupling::write_curves(folder_ / "curves.csv", press.record);
}

void RunFolder::write_results(Press const& press) const {
  write_curves(press);
  Summary const summary = summarise(press);
  write_summary(folder_ / "summary.json", summary);
  std::vector<std::string> frames;
  for (std::size_t k = 0; k < grains_.size(); ++k)
    frames.push_back(snapshot_name("grains", k, "h5"));
  write_run_file(folder_ / "run.h5", press.record, summary,
                 {.version = PRESSCHECK_VERSION,
                  .case_text = press.setup.resolved_text,
                  .seed = press.setup.powder.seed,
                  .threads = omp_get_max_threads()},
                 press.world.grains, frames);
  for (std::size_t t = 0; t < press.coupling.n_tools(); ++t)
    write_tool_stress(folder_ / "snapshots" / (press.coupling.tool(t).name + "_peak.vtu"),
                      press.coupling.tool(t), press.coupling.peak_load(t));
  write_press_report(press, folder_ / "report.html");
}

std::string RunFolder::last_restart() const {
  try {
    return fmt::format("the last good restart is {}", newest_restart(folder_).file.string());
  } catch (dem::InvalidInput const&) {
    return "there is no restart file yet";
  }
}

} // namespace coupling
