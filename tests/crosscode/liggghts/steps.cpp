#include "tests/crosscode/liggghts/steps.hpp"

#include "tests/crosscode/liggghts/deck_parts.hpp"
#include "tests/crosscode/liggghts/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace crosscode {
namespace {

constexpr double half_width = 0.02; // [m], of the box and of the plate

std::string walls_of(StepsDeck const& deck) {
  std::string text;
  if (deck.plate_speed)
    text += fmt::format(
        "fix plate all mesh/surface/stress file plate.stl type 3\n"
        "fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate\n"
        "fix motion all move/mesh mesh plate linear 0 0 {}\n",
        *deck.plate_speed);
  if (deck.bore_diameter)
    text += fmt::format(
        "fix bore all wall/gran model hertz tangential history primitive type 3 zcylinder {} 0 0\n",
        *deck.bore_diameter / 2.0);
  return text;
}

} // namespace

void write_steps_deck(StepsDeck const& deck, std::filesystem::path const& folder) {
  std::filesystem::create_directories(folder);
  write_text(folder / "grains.data", grain_data(deck.grains, half_width, -half_width, half_width));
  write_text(folder / "plate.stl", plate_stl(0.0, half_width));
  // Columns in the order of GrainState. `run` only once: each further one would recompute the first
  // forces.
  write_text(
      folder / "in.steps",
      open_box() + material_properties(250e6, 200e6, deck.cohesion) +
          pair_law(deck.friction_limit) +
          fmt::format("neighbor 0.0001 bin\nneigh_modify delay 0\ntimestep {}\n{}fix integrate all "
                      "nve/sphere\n"
                      "dump steps all custom 1 steps.txt id x y z vx vy vz omegax omegay omegaz "
                      "fx fy fz tqx tqy tqz\n"
                      "dump_modify steps format \"%d{}\"\nthermo 1000\nrun {}\n",
                      deck.dt, walls_of(deck),
                      " %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
                      " %.17g %.17g %.17g %.17g %.17g %.17g",
                      deck.n_steps));
}

std::vector<Frame> read_steps(std::filesystem::path const& file, std::size_t n_grains) {
  std::ifstream in(file);
  std::vector<Frame> frames;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("ITEM: ATOMS"))
      continue;
    Frame frame(n_grains);
    for (std::size_t n = 0; n < n_grains && std::getline(in, line); ++n) {
      std::istringstream words(line);
      std::size_t id = 0;
      words >> id;
      GrainState& g = frame.at(id - 1);
      for (dem::Vec3* v : {&g.position, &g.velocity, &g.spin, &g.force, &g.torque})
        words >> (*v)[0] >> (*v)[1] >> (*v)[2];
      if (!words)
        throw std::runtime_error(file.string() + ": an incomplete frame (the peer stopped early)");
    }
    frames.push_back(frame);
  }
  return frames;
}

std::array<double, 5> largest_deviations(std::vector<Frame> const& a, std::vector<Frame> const& b) {
  if (a.size() != b.size())
    throw std::runtime_error("the codes made different numbers of steps");
  std::array constexpr vectors{&GrainState::position, &GrainState::velocity, &GrainState::spin,
                               &GrainState::force, &GrainState::torque};
  std::array<double, 5> result{};
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    double deviation = 0.0, largest = 0.0;
    for (std::size_t step = 0; step < a.size(); ++step)
      for (std::size_t i = 0; i < a[step].size(); ++i) {
        dem::Vec3 const& left = a[step][i].*vectors[k];
        double const difference = (left - b[step].at(i).*vectors[k]).norm();
        if (!(difference <= deviation))
          deviation = difference; // also takes NaN
        largest = std::max(largest, left.norm());
      }
    result[k] = deviation / largest;
  }
  return result;
}

} // namespace crosscode
