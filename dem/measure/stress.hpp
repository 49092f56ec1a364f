#pragma once

#include "dem/contact/contact.hpp"
#include "dem/spheres.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace dem {

using Tensor = Eigen::Matrix3d;

/// Mean stress of each grain [Pa], compression positive:
///   sigma = -(1/V) sum over its contacts of l (x) F,   V = 4/3 pi R^3,
/// l from the grain's centre to the contact point, F the force on the grain there. In equilibrium
/// it is symmetric.
/// @returns n_grains tensors, in the order of the grains
/// Source: Love, A Treatise on the Mathematical Theory of Elasticity (1927), p. 618; Weber, Bull.
/// Liaison Ponts Chauss. 20 (1966) 3-1.
std::vector<Tensor> grain_stresses(Spheres const& grains, ContactStream const& contacts);

/// Mean stress [Pa] of all grains and their pores in `volume` [m^3], compression positive: the sum
/// of the grains' V sigma over the volume.
Tensor bulk_stress(Spheres const& grains, ContactStream const& contacts, double volume);

} // namespace dem
