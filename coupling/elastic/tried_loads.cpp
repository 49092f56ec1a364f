#include "coupling/elastic/tool_coupling.hpp"

#include <algorithm>

/// The part of ToolCoupling that the implicit mode asks: loads of all tools as one vector.
namespace coupling {
namespace {

// Middle between the ends of a window (1/2), which keeps the energy but lets an alternating error
// live for ever, and its end (1), which lags half a window.
constexpr double theta = 0.6;

} // namespace

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
  std::vector<Nodal> to;
  for (Course const& c : courses_)
    to.push_back(c.load_to);
  return joined(to);
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
    farthest = std::max(farthest,
                        tools_[t]->compliance.displacement(misses[t]).colwise().norm().maxCoeff());
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
