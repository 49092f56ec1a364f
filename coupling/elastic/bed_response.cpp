#include "coupling/elastic/nodal.hpp"
#include "coupling/elastic/tool_coupling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// The part of ToolCoupling that watches how stiff the bed is, and what the modes make of it.
namespace coupling {
namespace {

using namespace tool_rows;

// A force that changes by less between windows (a hold) says nothing about the bed's stiffness.
constexpr double least_change = 1e-3;

// Windows in a row with a coupling number above 1 that end an explicit run.
constexpr std::uint64_t windows_to_refuse = 5;

// In a window a load is not expected to grow by more.
constexpr double most_growth = 2.0;

} // namespace

/// Retreat along the load over the force, as the tool bears it now [m/N].
double ToolCoupling::compliance(std::size_t t) const {
  Course const& c = courses_[t];
  double const force = tools_[t]->pressing_force(c.load_from);
  if (force > 0.0 && dot(c.load_from, c.from) > 0.0)
    return dot(c.load_from, c.from) / (force * force);
  return tools_[t]->uniform_compliance;
}

double ToolCoupling::coupling_number() const {
  return bed_stiffness_ * (compliance(upper) + compliance(lower));
}

/// The bed's stiffness from this window and the last:  k_b = -dF / dg, g the gap where the loads
/// act: of the rigid motion, and f.u / F of each punch.
void ToolCoupling::watch_bed() {
  last_force_ = force_;
  last_gap_ = gap_;
  force_ = 0.0;
  gap_ = bed_height_ = gap_integral_ / time_;
  for (std::size_t const t : {upper, lower}) {
    double const force = tools_[t]->pressing_force(loads_[t]);
    force_ += 0.5 * force;
    if (walls_move() && force > 0.0)
      gap_ += 0.5 * dot(loads_[t], courses_[t].from + courses_[t].to) / force;
  }
  double const stiffness = (force_ - last_force_) / (last_gap_ - gap_);
  bool const is_pressed = checks_.windows > 0 && force_ > 0.0 && last_force_ > 0.0 &&
                          std::abs(force_ - last_force_) > least_change * force_;
  if (is_pressed && std::isfinite(stiffness) && stiffness > 0.0)
    bed_stiffness_ = bed_stiffness_ > 0.0 ? std::sqrt(bed_stiffness_ * stiffness) : stiffness;
}

/// Coupling number of both punches. A window shorter than a wave takes through the bed,
/// T < sqrt(m / k_b), meets only the part of it that the wave has reached, which is stiffer by
/// their ratio.
double ToolCoupling::punch_number() const {
  double const wave = planned_ * std::sqrt(bed_stiffness_ / bed_mass_);
  double const near = wave > 0.0 ? std::max(1.0, 1.0 / wave) : 1.0;
  return near * coupling_number();
}

/// A bed of the oedometric modulus M = k_b h / A answers a growth of its radius by M / R of radial
/// pressure: rho = 2 pi h M C = 2 pi h^2 k_b C / A.
double ToolCoupling::die_number() const {
  double const area = tools_[upper]->area;
  return 2.0 * dem::pi * bed_height_ * bed_height_ * bed_stiffness_ / area * compliance(die);
}

void ToolCoupling::refuse_divergence(dem::World const& world) const {
  if (choice_.mode != CouplingMode::two_way_explicit || windows_beyond_ < windows_to_refuse)
    return;
  throw dem::PhysicsGuard(
      fmt::format("t = {:.6g} s, step {}: two_way_explicit diverges (the bed is stiffer than the "
                  "tools: coupling number {:.3g}, limit 1). Mode = two_way_secant, or "
                  "two_way_implicit?",
                  world.time, world.step, checks_.coupling_number));
}

/// What the secant mode chooses from the loads of this window and the last. Only their size is
/// extrapolated and meets the bed: single grains come and go, and against one of them a tool is
/// stiff.
std::vector<ToolCoupling::Nodal> ToolCoupling::secant_loads() const {
  std::vector<Nodal> wanted = loads_;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    YieldingTool const& tool = *tools_[t];
    Course const& c = courses_[t];
    double const force = tool.pressing_force(loads_[t]);
    if (force <= 0.0 || checks_.windows == 0)
      continue;
    // From the middle of this window to the end of the next one, on a tool that goes on as it does.
    double const grows = 1.5 * (force - tool.pressing_force(c.last_load));
    double const ahead = std::clamp(force + grows, 0.0, most_growth * force);
    double const goes_on = tool.pressing_force(c.load_from + c.load_step);
    double const number = t == die ? die_number() : punch_number();
    wanted[t] *= std::max(goes_on + (ahead - goes_on) / (1.0 + number), 0.0) / force;
  }
  return wanted;
}

} // namespace coupling
