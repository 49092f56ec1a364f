#include "dem/contact/wall_yield.hpp"

#include "dem/contact/contact_store.hpp"

/// The part of the engine that only deformable tools need.
namespace dem {

template <class T> void TypedStore<T>::follow_tools(World const& world) {
#pragma omp parallel for schedule(dynamic, 1) if (lists_.blocks.size() > 1)
  for (std::size_t b = 0; b < lists_.blocks.size(); ++b) {
    ContactBlock<T>& block = lists_.blocks[b];
    std::vector<SurfacePoint> found;
    for (std::size_t k = 0; k < block.yields.size(); ++k) {
      WallContact const& wall = block.walls[k];
      Tool const& tool = world.tools[wall.tool];
      if (!tool.present || !tool.deformation)
        continue;
      WallYield& yield = block.yields[k];
      Vec3 const& u = yield.motion.displacement; // the old course will do to find the place
      Vec3 const centre = world.grains.position[wall.owner] - tool.displacement - u;
      found.clear();
      if (wall.inside_rim)
        found.push_back(tool.surface.on_patch(wall.patch, centre));
      else
        tool.surface.find(centre, 1.2 * world.grains.radius[wall.owner], found);
      for (SurfacePoint const& at : found)
        if (at.patch == wall.patch)
          yield.place = tool.deformation->locate(wall.patch, at.point);
      yield.motion = tool.deformation->at(yield.place);
    }
  }
}

/// Before the lists forget their contacts.
template <class T> void TypedStore<T>::keep_impulses() {
  for (ContactBlock<T>& block : lists_.blocks)
    for (std::size_t k = 0; k < block.yields.size(); ++k) {
      WallYield& yield = block.yields[k];
      if (yield.place.face != SurfacePlace::rigid && !yield.impulse.isZero(0.0))
        impulses_.push_back({block.walls[k].tool, yield.place, yield.impulse});
      yield.impulse.setZero();
    }
}

template <class T> std::vector<WallImpulse> TypedStore<T>::take_impulses() {
  keep_impulses();
  return std::exchange(impulses_, {});
}

template void TypedStore<float>::follow_tools(World const&);
template void TypedStore<double>::follow_tools(World const&);
template void TypedStore<float>::keep_impulses();
template void TypedStore<double>::keep_impulses();
template std::vector<WallImpulse> TypedStore<float>::take_impulses();
template std::vector<WallImpulse> TypedStore<double>::take_impulses();

} // namespace dem
