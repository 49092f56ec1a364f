#include "dem/measure/stress.hpp"

#include "dem/expect.hpp"

#include <cstddef>
#include <cstdint>

namespace dem {
namespace {

/// V sigma of each grain [J].
std::vector<Tensor> grain_virials(Spheres const& grains, ContactStream const& contacts) {
  std::vector<Tensor> virials(grains.size(), Tensor::Zero());
  auto const add = [&](std::uint32_t i, Vec3 const& point, Vec3 const& force) {
    virials[i] -= (point - grains.position[i]) * force.transpose();
  };
  contacts.for_each([&](Contact const& contact) {
    add(contact.i, contact.point, contact.force);
    if (contact.j != Contact::none)
      add(contact.j, contact.point, -contact.force);
  });
  return virials;
}

} // namespace

std::vector<Tensor> grain_stresses(Spheres const& grains, ContactStream const& contacts) {
  std::vector<Tensor> stresses = grain_virials(grains, contacts);
  for (std::size_t i = 0; i < grains.size(); ++i)
    stresses[i] /= sphere_volume(grains.radius[i]);
  return stresses;
}

Tensor bulk_stress(Spheres const& grains, ContactStream const& contacts, double volume) {
  EXPECT(volume > 0.0);
  Tensor sum = Tensor::Zero();
  for (Tensor const& virial : grain_virials(grains, contacts))
    sum += virial;
  return sum / volume;
}

} // namespace dem
