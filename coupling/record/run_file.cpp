#include "coupling/record/run_file.hpp"

#include "coupling/record/grains_check.hpp"
#include "coupling/record/h5.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace coupling {
namespace {

/// Rows of the grains in the order of their ids: neighbouring frames then compare row by row, and
/// the file does not depend on how the grains happen to be sorted in memory.
std::vector<std::size_t> order_by_id(dem::Spheres const& grains) {
  std::vector<std::size_t> rows(grains.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::ranges::sort(rows, {}, [&](std::size_t row) { return grains.id[row]; });
  return rows;
}

template <class T>
std::vector<T> ordered(std::vector<T> const& values, std::vector<std::size_t> const& rows) {
  std::vector<T> result;
  result.reserve(rows.size());
  for (std::size_t const row : rows)
    result.push_back(values[row]);
  return result;
}

void write_grains(H5Writer& file, dem::Spheres const& grains) {
  auto const rows = order_by_id(grains);
  auto const field = [&](std::string const& name, auto const& values, char const* unit,
                         char const* description) {
    file.write("grains/" + name, ordered(values, rows));
    file.describe("grains/" + name, unit, description);
  };
  field("position", grains.position, "m", "centre");
  field("velocity", grains.velocity, "m/s", "velocity of the centre");
  field("spin", grains.spin, "rad/s", "angular velocity");
  field("force", grains.force, "N", "sum of forces of the last step, gravity included");
  field("torque", grains.torque, "N m", "sum of torques of the last step");
  field("radius", grains.radius, "m", "radius");
  field("mass", grains.mass, "kg", "mass");
  field("material", grains.material, "1", "row of the component in the case");
  field("id", grains.id, "1", "name of the grain for its whole life");
}

void write_summary_values(H5Writer& file, Summary const& summary) {
  auto const value = [&](std::string const& name, double number, char const* unit,
                         char const* description) {
    file.write("summary/" + name, number);
    file.describe("summary/" + name, unit, description);
  };
  value("max_force", summary.max_force, "N", "largest force on the upper punch");
  value("ejection_force", summary.ejection_force, "N",
        "largest force on the lower punch while it pushes the compact out");
  value("porosity", summary.porosity, "1", "voids / compact volume, the seed's definition");
  value("porosity_core", summary.porosity_core, "1", "porosity of the inner cylinder");
  value("compact_height", summary.compact_height, "m", "highest minus lowest grain surface");
  value("springback", summary.springback, "1", "(compact height - smallest gap) / smallest gap");
  value("shape_quality", summary.shape_quality, "1", "1 to 5, 0 = not reached");
  value("shape_similarity", summary.shape_similarity, "1",
        "Kohonen similarity behind the shape quality");
  value("grains", static_cast<double>(summary.grains), "1", "number of grains");
  value("steps", static_cast<double>(summary.steps), "1", "number of time steps");
  value("time_step", summary.time_step, "s", "smallest time step used");
  value("wall_seconds", summary.wall_seconds, "s", "duration of the calculation");
  value("particle_steps_per_second", summary.particle_steps_per_second, "1/s",
        "grains times steps per second");
  file.write("summary/mode", summary.mode);

  std::vector<std::string> names;
  std::vector<double> values, tolerances;
  std::vector<std::uint8_t> verdicts;
  for (Check const& check : summary.checks) {
    names.push_back(check.name);
    values.push_back(check.value);
    tolerances.push_back(check.tolerance);
    verdicts.push_back(check.ok ? 1 : 0);
  }
  file.write("summary/checks/name", names);
  file.write("summary/checks/value", values);
  file.write("summary/checks/tolerance", tolerances);
  file.write("summary/checks/ok", verdicts);
}

void write_record(H5Writer& file, PressRecord const& record) {
  for (auto const& column : record.columns()) {
    file.write("curves/" + column.name, record.column(column.name));
    file.attribute("curves/" + column.name, "unit", column.unit);
  }
  file.write("curves/stage", record.stages());
}

} // namespace

void write_grain_frame(std::filesystem::path const& file, double time, std::string const& stage,
                       dem::Spheres const& grains) {
  H5Writer frame(file);
  frame.write("time", time);
  frame.describe("time", "s", "simulated time");
  frame.write("stage", stage);
  write_grains(frame, grains);
  frame.commit();
}

dem::Spheres read_grains(std::filesystem::path const& file) {
  H5Reader const reader(file);
  std::string const folder = reader.has("state/grains/position") ? "state/grains/" : "grains/";
  VALIDATE(reader.has(folder + "position"),
           fmt::format("{}: holds no grains. Is it a run.h5, a frame or a restart file?",
                       file.string()));
  check_grains(reader, folder);
  dem::Spheres grains;
  reader.read(folder + "position", grains.position);
  reader.read(folder + "velocity", grains.velocity);
  reader.read(folder + "spin", grains.spin);
  reader.read(folder + "force", grains.force);
  reader.read(folder + "torque", grains.torque);
  reader.read(folder + "radius", grains.radius);
  reader.read(folder + "mass", grains.mass);
  reader.read(folder + "material", grains.material);
  reader.read(folder + "id", grains.id);
  return grains;
}

void write_run_file(std::filesystem::path const& file, PressRecord const& record,
                    Summary const& summary, Provenance const& provenance, dem::Spheres const& last,
                    std::vector<std::string> const& frames) {
  H5Writer run(file);
  write_record(run, record);
  write_summary_values(run, summary);
  write_grains(run, last);
  for (auto const& frame : frames)
    run.link("snapshots/" + std::filesystem::path(frame).stem().string(), frame, "/");
  run.write("provenance/version", provenance.version);
  run.write("provenance/case_text", provenance.case_text);
  run.write("provenance/seed", provenance.seed);
  run.write("provenance/threads", provenance.threads);
  run.commit();
}

} // namespace coupling
