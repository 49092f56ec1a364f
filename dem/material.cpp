#include "dem/material.hpp"

#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <cmath>

namespace dem {

PairMaterial mix(Material const& i, Material const& j, Interaction const& interaction) {
  auto const normal_compliance = [](Material const& m) {
    return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.young_modulus;
  };
  auto const shear_compliance = [](Material const& m) {
    return 2.0 * (2.0 - m.poisson_ratio) * (1.0 + m.poisson_ratio) / m.young_modulus;
  };
  double const log_e = std::log(interaction.restitution);
  return {.effective_modulus = 1.0 / (normal_compliance(i) + normal_compliance(j)),
          .effective_shear_modulus = 1.0 / (shear_compliance(i) + shear_compliance(j)),
          .damping_ratio = log_e / std::sqrt(log_e * log_e + pi * pi),
          .interaction = interaction};
}

std::uint8_t MaterialTable::add(Material const& material) {
  EXPECT(material.density > 0.0 && material.young_modulus > 0.0);
  materials_.push_back(material);
  for (auto& row : interactions_)
    row.emplace_back();
  interactions_.emplace_back(materials_.size());
  return static_cast<std::uint8_t>(materials_.size() - 1);
}

void MaterialTable::set_interaction(std::uint8_t i, std::uint8_t j,
                                    Interaction const& interaction) {
  interactions_.at(i).at(j) = interaction;
  interactions_.at(j).at(i) = interaction;
}

PairMaterial MaterialTable::pair(std::uint8_t i, std::uint8_t j) const {
  return mix(materials_.at(i), materials_.at(j), interactions_.at(i).at(j));
}

} // namespace dem
