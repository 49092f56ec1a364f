#pragma once

#include "coupling/case_reader.hpp"

namespace coupling {

/// Refuses a case whose entries are each allowed but do not fit each other: shares that do not make
/// 100 %, powder that does not fit the die, stages that cannot follow each other, a tool that
/// outruns the time step, a cohesion that the grains cannot carry.
/// @param read  for the places of the entries
/// @throws dem::InvalidInput
void check_case(Case const& checked, CaseReader const& read);

/// The same for the shapes of deformable tools: bevels and cups that do not fit the punch, supports
/// that leave a tool from a mesh file free to turn. check_case asks it.
void check_tool_shapes(Case const& setup, CaseReader const& read);

/// Rayleigh time of one grain [s]:  pi R sqrt(rho/G) / (0.1631 nu + 0.8766),  G = E / (2 (1 + nu)).
/// Source: Li, Xu and Thornton, Powder Technol. 160 (2005) 219.
double rayleigh_time(dem::Material const& material, double radius);

} // namespace coupling
