#include "dem/packing/fill.hpp"

#include "dem/expect.hpp"
#include "dem/packing/level_grid.hpp"
#include "dem/packing/random_stream.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <utility>

namespace dem {
namespace {

constexpr int tries_while_free = 2000;
constexpr int tries_when_crowded = 50; // the relaxation decides then; more tries only help it start
constexpr int max_sweeps = 2000;
constexpr double densest_fill =
    0.58; // solid fraction beyond which a random start is not worth trying
constexpr double comfortable_fill = 0.45; // what a message recommends

std::string describe(FillVolume const& volume) {
  std::ostringstream text;
  text << "the fill cylinder (diameter " << 2e3 * volume.radius << " mm, height "
       << 1e3 * volume.height << " mm)";
  return text.str();
}

double cylinder_volume(FillVolume const& volume) {
  return pi * volume.radius * volume.radius * volume.height;
}

std::string way_out(double solid_fraction, FillVolume const& volume) {
  std::ostringstream text;
  text << "Raise the fill height to " << 1e3 * volume.height * solid_fraction / comfortable_fill
       << " mm or lower the total mass?";
  return text.str();
}

void validate(std::span<GrainClass const> classes, FillVolume const& volume) {
  VALIDATE(volume.radius > 0.0 && volume.height > 0.0 && volume.wall_clearance >= 0.0,
           "fill: " + describe(volume) + " has no room");
  for (GrainClass const& grains : classes) {
    bool const fits = grains.diameter * (1.0 + packing_clearance) <
                      std::min(2.0 * (volume.radius - volume.wall_clearance), volume.height);
    std::ostringstream problem;
    problem << "fill: a grain of diameter " << 1e3 * grains.diameter << " mm does not fit "
            << describe(volume) << ". Is a unit wrong?";
    VALIDATE(grains.count == 0 || fits, problem.str());
  }
  double const solid_fraction = solid_volume(classes) / cylinder_volume(volume);
  std::ostringstream problem;
  problem << "fill: the grains take " << 100.0 * solid_fraction << " % of " << describe(volume)
          << " (random filling without overlaps ends at about " << 100.0 * densest_fill << " %). "
          << way_out(solid_fraction, volume);
  VALIDATE(solid_fraction <= densest_fill, problem.str());
}

/// The grains without places: largest first, and within one size in random order, so that no
/// component gets the better places.
Packing list_grains(std::span<GrainClass const> classes, RandomStream& random) {
  std::vector<GrainClass> sorted(classes.begin(), classes.end());
  std::ranges::stable_sort(sorted, std::ranges::greater{}, &GrainClass::diameter);
  Packing grains;
  std::size_t size_begin = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    if (k > 0 && sorted[k].diameter < sorted[k - 1].diameter)
      size_begin = grains.size();
    bool const mixes = size_begin < grains.size();
    for (std::uint64_t n = 0; n < sorted[k].count; ++n)
      grains.push_back({.position = Vec3::Zero(),
                        .diameter = sorted[k].diameter,
                        .component = sorted[k].component});
    // One more component of this size: shuffle all of them again (Fisher-Yates).
    for (std::size_t last = grains.size(); mixes && last > size_begin + 1; --last)
      std::swap(grains[last - 1].component,
                grains[size_begin + random.below(last - size_begin)].component);
  }
  return grains;
}

/// Uniform among the centres at which a grain is inside. Neither sine nor square root, and an
/// explicit fused multiply-add: no library or compiler may move a bit.
Vec3 draw_centre(double radius, FillVolume const& volume, RandomStream& random) {
  double const keep = radius * (1.0 + packing_clearance);
  double const room = volume.radius - volume.wall_clearance - keep;
  double x, y;
  do {
    x = random.symmetric();
    y = random.symmetric();
  } while (std::fma(x, x, y * y) > 1.0);
  return clamp_inside(
      {room * x, room * y, std::fma(volume.height - 2.0 * keep, random.uniform(), keep)}, radius,
      volume);
}

/// Finds places one grain after another.
class Inserter {
public:
  Inserter(std::span<double const> radii, FillVolume const& volume, RandomStream& random)
      : radii_(radii), volume_(volume), random_(random),
        grid_(radii, Vec3(-volume.radius, -volume.radius, 0.0),
              Vec3(volume.radius, volume.radius, volume.height)) {}

  /// The first free place, or the least crowded of those tried.
  Vec3 insert(std::uint32_t grain) {
    Vec3 place = Vec3::Zero();
    if (is_crowded_ || !find_free(grain, place)) {
      is_crowded_ = true;
      place = find_least_crowded(grain);
    }
    grid_.insert(grain, place);
    return place;
  }

  bool is_crowded() const { return is_crowded_; }

private:
  bool find_free(std::uint32_t grain, Vec3& place) {
    for (int n = 0; n < tries_while_free; ++n) {
      place = draw_centre(radii_[grain], volume_, random_);
      if (overlap_at(grain, place, std::numeric_limits<double>::min()) == 0.0)
        return true;
    }
    return false;
  }

  Vec3 find_least_crowded(std::uint32_t grain) {
    Vec3 best = Vec3::Zero();
    double least_overlap = std::numeric_limits<double>::infinity();
    for (int n = 0; n < tries_when_crowded && least_overlap > 0.0; ++n) {
      Vec3 const place = draw_centre(radii_[grain], volume_, random_);
      double const overlap = overlap_at(grain, place, least_overlap);
      if (overlap >= least_overlap)
        continue;
      least_overlap = overlap;
      best = place;
    }
    return best;
  }

  /// Deepest overlap at a place, over the sum of the radii; 0 where it is free. The search ends at
  /// `enough`.
  double overlap_at(std::uint32_t grain, Vec3 const& place, double enough) const {
    double deepest = 0.0;
    grid_.meet_near(grain, place, 0.0, [&](std::uint32_t, Vec3 const& other, double radius) {
      double const free_distance = (radii_[grain] + radius) * (1.0 + packing_clearance);
      double const squared = (other - place).squaredNorm();
      if (squared >= free_distance * free_distance)
        return false;
      deepest = std::max(deepest, 1.0 - std::sqrt(squared) / free_distance);
      return deepest >= enough;
    });
    return deepest;
  }

  std::span<double const> radii_;
  FillVolume const& volume_;
  RandomStream& random_;
  LevelGrid grid_;
  bool is_crowded_ = false;
};

void make_room(std::vector<Vec3>& centres, std::span<double const> radii, FillVolume const& volume,
               double solid_fraction) {
  Relaxation const relaxation = relax_overlaps(centres, radii, volume, max_sweeps);
  std::ostringstream problem;
  problem << "fill: the grains take " << 100.0 * solid_fraction << " % of " << describe(volume)
          << " and overlaps of " << 100.0 * relaxation.largest_overlap << " % remain after "
          << relaxation.n_sweeps
          << " sweeps of pushing them apart (they are too many to lie free). "
          << way_out(solid_fraction, volume);
  VALIDATE(relaxation.is_free, problem.str());
}

} // namespace

Packing fill_cylinder(std::span<GrainClass const> classes, FillVolume const& volume,
                      std::uint64_t seed) {
  validate(classes, volume);
  RandomStream random(seed);
  Packing grains = list_grains(classes, random);
  std::vector<double> radii;
  for (PackedGrain const& grain : grains)
    radii.push_back(0.5 * grain.diameter);

  Inserter inserter(radii, volume, random);
  std::vector<Vec3> centres;
  for (std::uint32_t i = 0; i < grains.size(); ++i)
    centres.push_back(inserter.insert(i));
  if (inserter.is_crowded())
    make_room(centres, radii, volume, solid_volume(classes) / cylinder_volume(volume));

  for (std::size_t i = 0; i < grains.size(); ++i)
    grains[i].position = centres[i];
  return grains;
}

} // namespace dem
