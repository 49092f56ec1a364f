#include "coupling/elastic/tool_coupling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coupling {
namespace {

// Position of the tools in the press: die, upper punch, lower punch.
constexpr std::size_t die = 0, upper = 1, lower = 2;

// Middle between the ends of a window (1/2), which keeps the energy but lets an alternating error
// live for ever, and its end (1), which lags half a window.
constexpr double theta = 0.6;

// Below this share of the largest force so far a coupling number says nothing.
constexpr double under_load = 0.02;

// A force that changes by less between windows (a hold) says nothing about the bed's stiffness.
constexpr double least_change = 1e-3;
constexpr std::uint64_t windows_to_refuse = 5;

// In a window a load is not expected to grow by more.
constexpr double most_growth = 2.0;

double dot(Eigen::Matrix3Xd const& a, Eigen::Matrix3Xd const& b) {
  return (a.array() * b.array()).sum();
}

} // namespace

ToolCoupling::ToolCoupling(CouplingChoice choice,
                           std::vector<std::shared_ptr<YieldingTool const>> tools)
    : choice_(choice), tools_(std::move(tools)) {
  for (auto const& tool : tools_) {
    Nodal const zero = Nodal::Zero(3, static_cast<Eigen::Index>(tool->surface->n_nodes()));
    courses_.push_back({zero, zero, zero, zero, zero, zero, zero});
    loads_.push_back(zero);
  }
  wants_course_ = choice_.mode == CouplingMode::two_way_implicit ? 1 : 0;
}

/// How far the window has come, 1 at its planned end.
double ToolCoupling::progress(dem::World const& world) const {
  return planned_ > 0.0 && walls_move() ? world.window_time / planned_ : 0.0;
}

double ToolCoupling::retreat(std::size_t t, dem::World const& world) const {
  double const s = progress(world);
  return (1.0 - s) * tools_[t]->retreat(courses_[t].from) + s * tools_[t]->retreat(courses_[t].to);
}

double ToolCoupling::energy(dem::World const& world) const {
  double const s = progress(world);
  double total = 0.0;
  for (Course const& c : courses_)
    total += 0.5 * dot(c.load_from + s * (c.load_to - c.load_from), c.from + s * (c.to - c.from));
  return total;
}

/// Retreat along the load over the force, as the tool bears it now [m/N].
double ToolCoupling::compliance(std::size_t t) const {
  Course const& c = courses_[t];
  double const force = tools_[t]->pressing_force(c.load_from);
  if (force > 0.0 && dot(c.load_from, c.from) > 0.0)
    return dot(c.load_from, c.from) / (force * force);
  Nodal const& uniform = tools_[t]->pressure_loads;
  return tools_[t]->retreat_under(uniform) / tools_[t]->pressing_force(uniform);
}

double ToolCoupling::coupling_number() const {
  return bed_stiffness_ * (compliance(upper) + compliance(lower));
}

void ToolCoupling::step_done(dem::World& world, double gap, double dt) {
  if (is_rigid())
    return;
  if (bed_mass_ == 0.0)
    bed_mass_ = std::accumulate(world.grains.mass.begin(), world.grains.mass.end(), 0.0);
  time_ += dt;
  gap_integral_ += dt * gap;
  if (++steps_ == choice_.window)
    end_window(world);
}

/// Impulses of the window as mean nodal loads, with the checks of their transfer.
void ToolCoupling::take_loads(dem::World& world) {
  auto const impulses = world.contacts.take_impulses();
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    Nodal const nodal = tools_[t]->surface->nodal(impulses, t);
    auto const errors = tools_[t]->surface->errors(impulses, t, nodal);
    checks_.force = std::max(checks_.force, errors.force);
    checks_.moment = std::max(checks_.moment, errors.moment);
    checks_.power = std::max(checks_.power, errors.power);
    loads_[t] = nodal / time_;
  }
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

void ToolCoupling::keep_peak() {
  if (force_ <= peak_force_)
    return;
  peak_force_ = force_;
  for (std::size_t t = 0; t < tools_.size(); ++t)
    courses_[t].peak_load = loads_[t];
}

/// Where the window ended becomes the beginning of the next one.
void ToolCoupling::settle(dem::World const& world) {
  double const s = progress(world);
  double stored = 0.0;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    Course& c = courses_[t];
    Nodal const now = c.from + s * (c.to - c.from);
    checks_.work += dot(loads_[t], now - c.from);
    c.load_step = s * (c.load_to - c.load_from);
    c.load_from += c.load_step;
    c.from = now;
    if (!walls_move()) {
      c.load_from = loads_[t];
      c.from = tools_[t]->displacement(loads_[t]);
    }
    double const energy = 0.5 * dot(c.load_from, c.from);
    if (!world.tools[t].present) {
      checks_.released += walls_move() ? energy : 0.0;
      c.load_from.setZero();
      c.load_step.setZero();
      c.from.setZero();
    } else
      stored += energy;
  }
  if (walls_move())
    checks_.work_error =
        std::max(checks_.work_error, std::abs(checks_.work - checks_.released - stored));
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

void ToolCoupling::choose_loads(std::vector<Nodal> const& to, double length) {
  planned_ = length;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    courses_[t].load_to = to[t];
    courses_[t].to = tools_[t]->displacement(to[t]);
  }
}

void ToolCoupling::show_courses() const {
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    Course const& c = courses_[t];
    Nodal velocity = Nodal::Zero(3, c.from.cols());
    if (!walls_move()) {
      tools_[t]->surface->set_course(velocity, velocity, 0.0);
      continue;
    }
    if (planned_ > 0.0)
      velocity = (c.to - c.from) / planned_;
    tools_[t]->surface->set_course(c.from, velocity, planned_);
  }
}

void ToolCoupling::end_window(dem::World& world) {
  if (is_rigid() || steps_ == 0)
    return;
  take_loads(world);
  watch_bed();
  keep_peak();
  settle(world);
  double const number = coupling_number();
  if (force_ > under_load * peak_force_ && force_ > 0.0) {
    checks_.coupling_number = std::max(checks_.coupling_number, number);
    windows_beyond_ = number > 1.0 ? windows_beyond_ + 1 : 0;
  }
  refuse_divergence(world);
  bool const is_implicit = choice_.mode == CouplingMode::two_way_implicit;
  // A window cut short by the end of a stage is followed by one of full length.
  double const length = time_ / static_cast<double>(steps_) * static_cast<double>(choice_.window);
  if (walls_move() && !is_implicit)
    choose_loads(choice_.mode == CouplingMode::two_way_secant ? secant_loads() : loads_, length);
  for (std::size_t t = 0; t < tools_.size(); ++t)
    courses_[t].last_load = loads_[t];
  ++checks_.windows;
  wants_course_ = is_implicit ? 1 : 0;
  steps_ = 0;
  time_ = gap_integral_ = 0.0;
  world.window_time = 0.0;
  show_courses();
  world.contacts.follow_tools(world);
}

Eigen::VectorXd ToolCoupling::joined(std::vector<Nodal> const& parts) const {
  Eigen::Index n = 0;
  for (Nodal const& part : parts)
    n += part.size();
  Eigen::VectorXd all(n);
  n = 0;
  for (Nodal const& part : parts) {
    all.segment(n, part.size()) = Eigen::Map<Eigen::VectorXd const>(part.data(), part.size());
    n += part.size();
  }
  return all;
}

std::vector<ToolCoupling::Nodal> ToolCoupling::parted(Eigen::VectorXd const& all) const {
  std::vector<Nodal> parts;
  Eigen::Index n = 0;
  for (Course const& c : courses_) {
    parts.emplace_back(Eigen::Map<Nodal const>(all.data() + n, 3, c.from.cols()));
    n += c.from.size();
  }
  return parts;
}

Eigen::VectorXd ToolCoupling::predicted() const {
  return joined(secant_loads());
}

Eigen::VectorXd ToolCoupling::mean_loads(dem::World& world, double time) const {
  auto const impulses = world.contacts.take_impulses();
  std::vector<Nodal> loads;
  for (std::size_t t = 0; t < tools_.size(); ++t)
    loads.emplace_back(tools_[t]->surface->nodal(impulses, t) / time);
  return joined(loads);
}

Eigen::VectorXd ToolCoupling::wanted(Eigen::VectorXd const& loads) const {
  std::vector<Nodal> from;
  for (Course const& c : courses_)
    from.push_back(c.load_from);
  return (loads - (1.0 - theta) * joined(from)) / theta;
}

double ToolCoupling::first_relaxation() const {
  return 1.0 / (1.0 + punch_number());
}

bool ToolCoupling::is_converged(Eigen::VectorXd const& to, Eigen::VectorXd const& wanted,
                                double length) const {
  if ((wanted - to).norm() <= choice_.tolerance * wanted.norm())
    return true;
  auto const misses = parted(wanted - to);
  double farthest = 0.0;
  for (std::size_t t = 0; t < tools_.size(); ++t)
    farthest = std::max(farthest, tools_[t]->displacement(misses[t]).colwise().norm().maxCoeff());
  return farthest <= 0.01 * choice_.tolerance * length;
}

void ToolCoupling::choose(dem::World& world, Eigen::VectorXd const& to, double length) {
  choose_loads(parted(to), length);
  wants_course_ = 0;
  show_courses();
  world.contacts.follow_tools(world);
}

void ToolCoupling::count_iterations(std::uint64_t n) {
  checks_.iterations += n;
  checks_.most_iterations = std::max(checks_.most_iterations, n);
}

} // namespace coupling
