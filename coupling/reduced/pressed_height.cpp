#include "coupling/reduced/pressed_height.hpp"

#include "coupling/measured/limits.hpp"
#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coupling::reduced {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::array<std::string_view, 5> names{"frame_compliance", "gap_offset", "thermal_drift",
                                                "mass_error", "die_size"};

double drift_of(Machine const& machine, double t) {
  double const e = machine.frame.thermal_drift, w = machine.drift_decay;
  return w > 0.0 ? e * -std::expm1(-w * t) / w : e * t;
}

/// Springback and density at a point.
struct Compact {
  double springback, radial, density;
};

double height_at_peak(Press const& press, HeightRow const& row) {
  auto const& machine = press.machine;
  double const stretch = machine.gap_is_of_faces ? 0.0 : machine.frame.deflection(row.force);
  return row.gap + machine.frame.gap_offset + drift_of(machine, row.time) + stretch;
}

double value_of(Press const& press, Compact const& compact, HeightRow const& row) {
  double const peak = height_at_peak(press, row);
  double const height = peak * (1.0 + compact.springback);
  double const stretch = press.machine.frame.deflection(row.force);
  switch (row.asked) {
  case Asked::compact_height:
    return height;
  case Asked::porosity: {
    double const wider = 1.0 + compact.radial * compact.springback;
    double const solid = press.solid_density / compact.density * press.pressed.bed.solid_area;
    return 1.0 - solid / (wider * wider * height);
  }
  case Asked::height_less_gap:
    return height - row.gap;
  case Asked::gap_at_peak:
    return peak;
  case Asked::blank_travel:
    return stretch;
  case Asked::blank_zero:
    return -press.machine.frame.gap_offset;
  case Asked::opening_travel:
    return compact.springback * peak + stretch;
  }
  return 0.0;
}

} // namespace

PressedHeight::PressedHeight(Known known, std::vector<HeightRow> rows)
    : known_(std::move(known)), rows_(std::move(rows)) {
  VALIDATE(!rows_.empty(), "measured data: no run holds a compact_height or a porosity (there is "
                           "nothing that a gap could be held against). Add one to its scalars?");
  known_.nominal.machine.gap_is_of_faces = known_.gap_is_of_faces;
  calibrated_.push_back({.name = "springback",
                         .unit = "1",
                         .mean = known_.springback.mean,
                         .sd = known_.springback.sd,
                         .low = 0.0});
  // A density acts on porosities alone; elsewhere nothing would tell it.
  bool const has_porosity = std::ranges::count(rows_, Asked::porosity, &HeightRow::asked) > 0;
  if (has_porosity)
    calibrated_.push_back({.name = "solid_density",
                           .unit = "kg/m^3",
                           .mean = known_.solid_density.value,
                           .sd = known_.solid_density.sd,
                           .low = 0.1 * known_.solid_density.value});
  for (auto const& cause : known_causes()) {
    if (std::ranges::find(names, cause.mechanism.name) == names.end())
      continue;
    auto mechanism = cause.mechanism;
    if (mechanism.name == "gap_offset" && !known_.gap_is_of_faces) {
      mechanism.scale =
          std::hypot(mechanism.scale, measured::limits::end_gap_share * known_.stroke);
      mechanism.low = -10.0 * mechanism.scale, mechanism.high = 10.0 * mechanism.scale;
    }
    causes_.push_back(cause);
    mechanisms_.push_back(std::move(mechanism));
  }
  scatters_ = {{"mass", "1", known_.mass_sd}, {"gap", "m", known_.gap_sd}};
}

PressedHeight PressedHeight::with_rows(std::vector<HeightRow> rows) const {
  auto copy = *this;
  copy.rows_ = std::move(rows);
  return copy;
}

Press PressedHeight::press_at(diagnosis::Parameters const& at) const {
  Press press = known_.nominal;
  for (std::size_t j = 0; j < causes_.size(); ++j)
    if (double const size = at.sizes[static_cast<Index>(j)]; size != 0.0)
      causes_[j].apply(press, size, at.shapes[j]);
  press.pressed.bed.solid_area *= 1.0 + at.scatter[0];
  press.machine.frame.gap_offset += at.scatter[1];
  return press;
}

VectorXd PressedHeight::predict(diagnosis::Parameters const& at) const {
  Press const press = press_at(at);
  Compact const compact{.springback = at.calibrated[0],
                        .radial = known_.springback.radial_share,
                        .density = at.calibrated.size() > 1 ? at.calibrated[1]
                                                            : known_.solid_density.value};
  VectorXd values(static_cast<Index>(rows_.size()));
  for (std::size_t k = 0; k < rows_.size(); ++k)
    values[static_cast<Index>(k)] = value_of(press, compact, rows_[k]);
  return values;
}

HeightRows height_rows(measured::MeasuredData const& data) {
  HeightRows result;
  for (auto const& run : data.runs) {
    if (run.role != measured::Role::fit || run.has_curve())
      continue;
    auto const& press = run.press;
    for (auto const& [name, number] : run.scalars) {
      bool const is_porosity = name == "porosity";
      if (!is_porosity && name != "compact_height") {
        if (name != "max_force")
          result.left_out.push_back(fmt::format(
              "{}: {} says nothing of gap and height, and is not used", run.file, name));
        continue;
      }
      result.rows.push_back({.asked = is_porosity ? Asked::porosity : Asked::compact_height,
                             .gap = press.end_gap,
                             .force = run.scalars.at("max_force").value,
                             .time = (press.fill_height - press.end_gap) / press.speed_down});
      result.blocks.push_back({.run = run.file,
                               .channel = name,
                               .phase = diagnosis::Phase::after,
                               .coordinate = VectorXd::Zero(1),
                               .values = VectorXd::Constant(1, number.value)});
      auto const known =
          std::ranges::find(result.channels, name, &diagnosis::ChannelError::channel);
      // Geometry is exact: what it does not know is springback and density, which are calibrated.
      if (known == result.channels.end())
        result.channels.push_back({.channel = name, .sd = number.sd, .model_share = 0.0});
      else
        known->sd = std::max(known->sd, number.sd);
    }
  }
  return result;
}

} // namespace coupling::reduced
