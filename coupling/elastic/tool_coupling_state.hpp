#pragma once

#include "coupling/elastic/tool_coupling.hpp"
#include "dem/expect.hpp"

/// What a restart keeps of the coupling; included by tool_coupling.hpp.
namespace coupling {

/// Shows a nodal field as a flat array and takes it back.
template <class Field>
void visit_nodal(std::string const& name, Eigen::Matrix3Xd& nodal, Field&& field) {
  std::vector<double> values(nodal.data(), nodal.data() + nodal.size());
  field(name, values);
  VALIDATE(values.size() == static_cast<std::size_t>(nodal.size()),
           "restart: its tools have other meshes than the case's. Is the file from another case?");
  std::copy(values.begin(), values.end(), nodal.data());
}

template <class Field> void ToolCoupling::visit_state(Field&& field) {
  if (is_rigid())
    return;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    std::string const at = "elastic/" + tools_[t]->name + "/";
    visit_nodal(at + "load_from", courses_[t].load_from, field);
    visit_nodal(at + "load_to", courses_[t].load_to, field);
    visit_nodal(at + "load_step", courses_[t].load_step, field);
    visit_nodal(at + "from", courses_[t].from, field);
    visit_nodal(at + "to", courses_[t].to, field);
    visit_nodal(at + "last_load", courses_[t].last_load, field);
    visit_nodal(at + "peak_load", courses_[t].peak_load, field);
  }
  std::string const at = "elastic/";
  field(at + "force_error", checks_.force);
  field(at + "moment_error", checks_.moment);
  field(at + "power_error", checks_.power);
  field(at + "work", checks_.work);
  field(at + "released", checks_.released);
  field(at + "work_error", checks_.work_error);
  field(at + "coupling_number", checks_.coupling_number);
  field(at + "most_iterations", checks_.most_iterations);
  field(at + "windows", checks_.windows);
  field(at + "iterations", checks_.iterations);
  field(at + "wants_course", wants_course_);
  field(at + "planned", planned_);
  field(at + "steps", steps_);
  field(at + "time", time_);
  field(at + "gap_integral", gap_integral_);
  field(at + "gap", gap_);
  field(at + "last_gap", last_gap_);
  field(at + "force", force_);
  field(at + "last_force", last_force_);
  field(at + "peak_force", peak_force_);
  field(at + "bed_stiffness", bed_stiffness_);
  field(at + "bed_height", bed_height_);
  field(at + "bed_mass", bed_mass_);
  field(at + "windows_beyond", windows_beyond_);
}

} // namespace coupling
