#include "dem/packing/packing.hpp"

#include "dem/expect.hpp"

#include <algorithm>
#include <cstddef>

namespace dem {

Spheres make_spheres(Packing const& packing, std::span<PackingComponent const> components) {
  Spheres grains;
  for (PackedGrain const& grain : packing) {
    EXPECT(grain.component < components.size());
    PackingComponent const& component = components[grain.component];
    grains.add(grain.position, 0.5 * grain.diameter, component.density, component.material,
               grain.velocity, grain.spin);
  }
  return grains;
}

Packing make_packing(Spheres const& grains, std::span<PackingComponent const> components) {
  Packing packing(grains.size());
  for (std::size_t i = 0; i < grains.size(); ++i) {
    auto const component =
        std::ranges::find(components, grains.material[i], &PackingComponent::material);
    VALIDATE(component != components.end(),
             "packing: grain " + std::to_string(grains.id[i]) + " has material " +
                 std::to_string(grains.material[i]) +
                 " (no component of the powder is made of it). Is it another case's state?");
    packing[grains.id[i]] = {.position = grains.position[i],
                             .diameter = 2.0 * grains.radius[i],
                             .component = static_cast<std::uint8_t>(component - components.begin()),
                             .velocity = grains.velocity[i],
                             .spin = grains.spin[i]};
  }
  return packing;
}

} // namespace dem
