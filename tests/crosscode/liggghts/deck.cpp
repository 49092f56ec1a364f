#include "tests/crosscode/liggghts/deck.hpp"

#include "tests/crosscode/liggghts/deck_parts.hpp"
#include "tests/crosscode/liggghts/text_file.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace crosscode {
namespace {

/// The plates are wider than the bore by far.
double half_width(PressDeck const& deck) {
  return 2.0 * deck.bore_diameter;
}

// Two traps. `neigh_modify` with one or page makes each later run forget the tangential springs.
// Only one wall fix may own meshes, so it owns both punches.
std::string physics(PressDeck const& deck) {
  return open_box() + material_properties(deck.young_modulus, deck.wall_modulus, deck.cohesion) +
         fmt::format("neighbor {} bin\nneigh_modify delay 0\n{}"
                     "fix gravity all gravity 9.81 vector 0 0 -1\n"
                     "fix lower all mesh/surface/stress file lower.stl type 3\n"
                     "fix upper all mesh/surface/stress file upper.stl type 3\n"
                     "fix punches all wall/gran model hertz tangential history mesh n_meshes 2 "
                     "meshes lower upper\n"
                     "fix bore all wall/gran model hertz tangential history primitive type 3 "
                     "zcylinder {} 0 0\n"
                     "fix integrate all nve/sphere\n",
                     deck.skin, pair_law(FrictionLimit::net), deck.bore_diameter / 2.0);
}

std::string programme(PressDeck const& deck) {
  std::string text =
      "variable force_upper equal f_upper[3]\nvariable force_lower equal -f_lower[3]\n"
      "thermo_style custom step atoms ke cpu\nthermo 10000\nthermo_modify lost error\n";
  double gap = deck.start_gap;
  double time = 0.0;
  long step = 0;
  for (std::size_t n = 0; n < deck.moves.size(); ++n) {
    auto const& [speed, n_steps, dt] = deck.moves[n];
    text += fmt::format(
        "timestep {0}\nvariable now equal {1}+(step-{2})*{0}\n"
        "variable gap equal {3}+{4}*(step-{2})*{0}\n"
        "fix motion all move/mesh mesh upper linear 0 0 {4}\n"
        "fix record all print {5} \"${{now}} ${{gap}} ${{force_upper}} ${{force_lower}}\" "
        "append curves.txt screen no title \"\"\n",
        dt, time, step, gap, speed, deck.record_every);
    step += n_steps;
    time += static_cast<double>(n_steps) * dt;
    gap += speed * static_cast<double>(n_steps) * dt;
    text += fmt::format(
        "dump state{0} all custom {1} state_{0}.txt id x y z vx vy vz omegax omegay omegaz\n"
        "dump_modify state{0} first no format \"%d{2}\"\n"
        "run {3}\nundump state{0}\nunfix record\nunfix motion\n",
        n, step, " %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g", n_steps);
  }
  return text;
}

} // namespace

void write_press_deck(PressDeck const& deck, dem::Packing const& packing,
                      std::filesystem::path const& folder) {
  std::filesystem::create_directories(folder);
  std::filesystem::remove(folder / "curves.txt"); // the peer appends
  double const side = half_width(deck);
  write_text(folder / "grains.data", grain_data(packing, side, -side, deck.start_gap + side));
  write_text(folder / "lower.stl", plate_stl(0.0, side));
  write_text(folder / "upper.stl", plate_stl(deck.start_gap, side));
  write_text(folder / "in.press", physics(deck) + programme(deck));
}

dem::Packing read_state(std::filesystem::path const& file, dem::Packing const& initial) {
  std::ifstream in(file);
  dem::Packing packing = initial;
  std::size_t n_read = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("ITEM:")) {
      if (line.starts_with("ITEM: ATOMS"))
        n_read = 0; // the last frame counts
      continue;
    }
    std::istringstream words(line);
    std::size_t id = 0;
    std::array<double, 9> v{};
    words >> id;
    for (double& value : v)
      words >> value;
    if (!words)
      continue; // box bounds and counts
    dem::PackedGrain& g = packing.at(id - 1);
    g.position = {v[0], v[1], v[2]};
    g.velocity = {v[3], v[4], v[5]};
    g.spin = {v[6], v[7], v[8]};
    ++n_read;
  }
  if (n_read != initial.size())
    throw std::runtime_error(
        fmt::format("{}: {} grains of {} (the peer stopped early or lost some)", file.string(),
                    n_read, initial.size()));
  return packing;
}

} // namespace crosscode
