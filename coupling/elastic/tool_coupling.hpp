#pragma once

#include "coupling/elastic/yielding_tool.hpp"
#include "dem/step/world.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace coupling {

/// What the windows of a run kept, and where it stood worst.
struct CouplingChecks {
  double force = 0.0, moment = 0.0, power = 0.0; ///< [1], of the transfer, largest so far
  double work = 0.0;            ///< [J], done by the grains on the deformation of tools
  double released = 0.0;        ///< [J], of it that went with removed tools
  double work_error = 0.0;      ///< [J], largest |work - released - stored|
  double coupling_number = 0.0; ///< [1], k_b C, largest under load
  std::uint64_t windows = 0;
  std::uint64_t iterations = 0, most_iterations = 0; ///< implicit: of all windows, of one window
};

/// How the tools of a press deform under its grains.
///
/// Time is cut into windows of some steps. Within a window every node of a pressed surface moves on
/// a straight line (World::window_time); at its end the impulses of the grains, over its length,
/// are nodal loads f. The deformation is kept as the loads g that hold it, u = C g with the
/// condensed compliance C, so its energy is g.u / 2 at any time. The modes choose the next g:
///   one_way            walls stay rigid; g = f is what they would have to bear
///   two_way_explicit   g = f. Diverges once the coupling number k_b C reaches 1, and stops then
///   two_way_secant     f, scaled: its force F goes on as it does, and so does that of g, G; they
///                      meet against the bed, whose stiffness k_b the last windows showed, at
///                      G + w (F - G), w = 1 / (1 + k_b sum C) for the punches, and likewise for
///                      the die
///   two_way_implicit   the window is tried until its own loads hold its deformation:
///                      theta g + (1 - theta) g_before = f(g). See implicit_window.hpp
class ToolCoupling {
public:
  /// Rigid tools.
  ToolCoupling() = default;
  ToolCoupling(CouplingChoice choice, std::vector<std::shared_ptr<YieldingTool const>> tools);

  bool is_rigid() const { return choice_.mode == CouplingMode::rigid; }
  CouplingChoice const& choice() const { return choice_; }
  std::size_t n_tools() const { return tools_.size(); }
  YieldingTool const& tool(std::size_t t) const { return *tools_[t]; }
  CouplingChecks const& checks() const { return checks_; }

  /// Before a step of an implicit window: it still wants its course.
  bool wants_course() const { return wants_course_ != 0; }

  /// After every step.
  /// @param gap  of the punches' rigid motion [m]
  /// @param dt   [s]
  void step_done(dem::World& world, double gap, double dt);

  /// Ends the window where it stands: after its last step, or when a stage ends.
  /// @throws dem::PhysicsGuard if the explicit mode diverges
  void end_window(dem::World& world);

  /// Shows the surfaces their courses again: after a state has been put back.
  void show_courses() const;

  // For the implicit mode: loads of all tools as one vector, tool by tool, node by node.
  Eigen::VectorXd predicted() const; ///< g that the secant mode has chosen
  /// Mean loads of the impulses since the window began, `time` [s] ago.
  Eigen::VectorXd mean_loads(dem::World& world, double time) const;
  Eigen::VectorXd wanted(Eigen::VectorXd const& loads) const; ///< g that these loads hold
  double first_relaxation() const;                            ///< 1 / (1 + k_b C)
  /// Whether loads are met to the tolerance, or no node would move by more than a hundredth of the
  /// tolerance times `length` [m].
  bool is_converged(Eigen::VectorXd const& to, Eigen::VectorXd const& wanted, double length) const;
  /// Sets the course of the window to these loads at its end.
  void choose(dem::World& world, Eigen::VectorXd const& to, double length);
  void count_iterations(std::uint64_t n);

  /// As it is now: mean retreat of a tool's surface [m], energy stored in all tools [J].
  double retreat(std::size_t t, dem::World const& world) const;
  double energy(dem::World const& world) const;
  /// k_b C of the punches [1], with the bed's stiffness as the last windows showed it.
  double coupling_number() const;

  /// Whether a window has ended and no step of the next one is done.
  bool is_between_windows() const { return steps_ == 0 && checks_.windows > 0; }
  /// Nodal loads of a tool [N], mean of the last window.
  Eigen::Matrix3Xd const& last_load(std::size_t t) const { return courses_[t].last_load; }
  /// Largest punch force of a window so far [N].
  double peak_force() const { return peak_force_; }
  /// Nodal loads of a tool [N] in the window whose punch force was largest.
  Eigen::Matrix3Xd const& peak_load(std::size_t t) const { return courses_[t].peak_load; }

  template <class Field> void visit_state(Field&& field);

private:
  using Nodal = Eigen::Matrix3Xd;
  struct Course {
    Nodal load_from, load_to; ///< [N], g at the beginning and the planned end
    Nodal load_step;          ///< [N], what g has gone in the last window
    Nodal from, to;           ///< [m], C g
    Nodal last_load;          ///< [N], mean of the last window
    Nodal peak_load;          ///< [N]
  };

  bool walls_move() const { return choice_.mode != CouplingMode::one_way; }
  double progress(dem::World const& world) const;
  void take_loads(dem::World& world);
  void watch_bed();
  void keep_peak();
  void settle(dem::World const& world);
  void choose_loads(std::vector<Nodal> const& to, double length);
  Eigen::VectorXd joined(std::vector<Nodal> const& parts) const;
  std::vector<Nodal> parted(Eigen::VectorXd const& all) const;
  std::vector<Nodal> secant_loads() const;
  double punch_number() const;
  double die_number() const;
  double compliance(std::size_t t) const;
  void refuse_divergence(dem::World const& world) const;

  CouplingChoice choice_;
  std::vector<std::shared_ptr<YieldingTool const>> tools_;
  std::vector<Course> courses_;
  std::vector<Nodal> loads_; // [N], means of the window that has just ended
  CouplingChecks checks_;

  std::uint64_t wants_course_ = 0;
  double planned_ = 0.0; // [s], length of the window
  std::uint64_t steps_ = 0;
  double time_ = 0.0, gap_integral_ = 0.0; // [s], [m s]
  double gap_ = 0.0, last_gap_ = 0.0;      // [m], means of this window and the last
  double force_ = 0.0, last_force_ = 0.0;  // [N], of the punches
  double peak_force_ = 0.0;                // [N]
  double bed_stiffness_ = 0.0;             // [N/m]
  double bed_height_ = 0.0;                // [m]
  double bed_mass_ = 0.0;                  // [kg]
  std::uint64_t windows_beyond_ = 0;       // in a row whose coupling number exceeds 1
};

} // namespace coupling

#include "coupling/elastic/tool_coupling_state.hpp"
