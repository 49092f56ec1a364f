#include "coupling/elastic/tool_coupling.hpp"

#include "coupling/elastic/nodal.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coupling {
namespace {

using namespace tool_rows;

// Below this share of the largest force so far a coupling number says nothing.
constexpr double under_load = 0.02;

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

void ToolCoupling::step_done(dem::World& world, double gap, double dt) {
  if (is_rigid())
    return;
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
      c.from = tools_[t]->compliance.displacement(loads_[t]);
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

void ToolCoupling::choose_loads(std::vector<Nodal> const& to, double length) {
  planned_ = length;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    courses_[t].load_to = to[t];
    courses_[t].to = tools_[t]->compliance.displacement(to[t]);
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
  bed_mass_ = std::accumulate(world.grains.mass.begin(), world.grains.mass.end(), 0.0);
  watch_bed();
  keep_peak();
  settle(world);
  double const number = coupling_number();
  if (force_ > under_load * peak_force_ && force_ > 0.0) {
    checks_.coupling_number = std::max(checks_.coupling_number, number);
    windows_beyond_ = number > 1.0 ? windows_beyond_ + 1 : 0;
  }
  refuse_divergence(world);
  // A window cut short by the end of a stage is followed by one of full length.
  double const length = time_ / static_cast<double>(steps_) * static_cast<double>(choice_.window);
  // The secant's course is also what the implicit mode tries first.
  if (walls_move())
    choose_loads(choice_.mode == CouplingMode::two_way_explicit ? loads_ : secant_loads(), length);
  for (std::size_t t = 0; t < tools_.size(); ++t)
    courses_[t].last_load = loads_[t];
  ++checks_.windows;
  wants_course_ = choice_.mode == CouplingMode::two_way_implicit ? 1 : 0;
  steps_ = 0;
  time_ = gap_integral_ = 0.0;
  world.window_time = 0.0;
  show_courses();
  world.contacts.follow_tools(world);
}

} // namespace coupling
