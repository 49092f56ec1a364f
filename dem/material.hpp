#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace dem {

/// An isotropic elastic material of grains or tools.
struct Material {
  std::string name;
  double density;       ///< [kg/m^3], > 0
  double young_modulus; ///< [Pa], > 0
  double poisson_ratio; ///< [1], in (-1, 0.5)
};

/// What two materials do to each other at a contact.
struct Interaction {
  double restitution = 0.5;             ///< [1], in (0, 1]
  double static_friction = 0.2;         ///< [1], >= 0
  double rolling_friction = 0.0;        ///< [1], >= 0
  double cohesion_energy_density = 0.0; ///< [J/m^3], >= 0 (sjkr, sjkr2, linear)
  double surface_energy = 0.0;          ///< [J/m^2], work of adhesion of the pair, >= 0 (jkr)
};

/// The mixed values of a pair of materials.
///   1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j
///   1/G* = 2 (2 - nu_i)(1 + nu_i)/E_i + 2 (2 - nu_j)(1 + nu_j)/E_j
///   beta = ln e / sqrt(ln^2 e + pi^2)     (<= 0)
/// Source: Di Renzo and Di Maio, Chem. Eng. Sci. 59 (2004) 525.
struct PairMaterial {
  double effective_modulus;       ///< E* [Pa]
  double effective_shear_modulus; ///< G* [Pa]
  double damping_ratio;           ///< beta [1], in (-1, 0]
  Interaction interaction;
};

PairMaterial mix(Material const& i, Material const& j, Interaction const& interaction);

/// All materials of a case and what each pair of them does; symmetric in the pair.
class MaterialTable {
public:
  /// @returns the row of the new material
  std::uint8_t add(Material const& material);
  void set_interaction(std::uint8_t i, std::uint8_t j, Interaction const& interaction);

  std::size_t size() const { return materials_.size(); }
  Material const& operator[](std::uint8_t row) const { return materials_[row]; }
  PairMaterial pair(std::uint8_t i, std::uint8_t j) const;

private:
  std::vector<Material> materials_;
  std::vector<std::vector<Interaction>> interactions_; // n x n, symmetric
};

} // namespace dem
