#pragma once

#include "continuum/powder/cap_model.hpp"
#include "continuum/powder/modified_cam_clay.hpp"
#include "continuum/powder/powder_state.hpp"

#include <string>
#include <variant>

/// Laws of the pressed powder as values. A law is isotropic and works in principal axes; strain and
/// stress are TENSION POSITIVE here, as in continuum/tool. Finite strain is the caller's: F = Fe
/// Fp, Hencky strain, and a step gives the law the principal logarithmic strains of its elastic
/// trial (material_point.hpp). A further law is a struct with respond, relative_density and
/// validate, and one word in the list.
namespace continuum {

using PowderLaw = std::variant<DruckerPragerCap, ModifiedCamClay>;

/// One implicit step of any law, and its exact consistent tangent.
/// @param old           state at the step's beginning
/// @param trial_strain  principal elastic logarithmic strains if the step were elastic [-]
/// @return  the step's end, or the reason why there is none: then cut the step
PowderResult respond(PowderLaw const& law, PowderState const& old,
                     Eigen::Vector3d const& trial_strain);

/// D = D_0 exp(eps_v^p) [-]: density of the unloaded powder.
double relative_density(PowderLaw const& law, PowderState const& state);

/// @throws InvalidInput with the entry, its value and why it cannot be
void validate(PowderLaw const& law, std::string const& name);

} // namespace continuum
