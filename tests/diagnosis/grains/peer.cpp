#include "tests/diagnosis/grains/peer.hpp"

#include "tests/diagnosis/hide/press.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

namespace hidden {
namespace {

constexpr double fill_height = 20 * mm, open_gap = 12.5 * mm, speed = 0.2; // [m], [m/s]

/// Beside the bore; the punches are wider still.
constexpr double half_width = 2.0 * stated_bore;

/// The quick case's grains: what 9.13 g make of its size classes.
struct Class {
  int type; ///< 1 MgO, 2 alumina
  double density, diameter;
  int number;
};
constexpr Class classes[] = {{1, 3500, 3 * mm, 22},
                             {1, 3500, 2 * mm, 125},
                             {1, 3500, 1.2 * mm, 1384},
                             {2, 3000, 1.2 * mm, 673}};

/// The peer takes seeds only if they are prime and above 10000. The n-th prime above a place of the
/// packing's own.
long prime_seed(std::uint64_t packing, int n) {
  auto const is_prime = [](long p) {
    for (long d = 2; d * d <= p; ++d)
      if (p % d == 0)
        return false;
    return true;
  };
  long p = 10001 + 1000 * static_cast<long>(packing % 1000000);
  for (int k = 0; k <= n; ++k)
    do
      ++p;
    while (!is_prime(p));
  return p;
}

std::string materials(GrainPress const& press) {
  double const f = press.friction, w = press.wall_friction, c = press.cohesion_density;
  return fmt::format("fix m1 all property/global youngsModulus peratomtype {0} {0} 200e6\n"
                     "fix m2 all property/global poissonsRatio peratomtype 0.25 0.25 0.29\n"
                     "fix m3 all property/global coefficientRestitution peratomtypepair 3 "
                     "0.5 0.5 0.5 0.5 0.5 0.5 0.5 0.5 0.5\n"
                     "fix m4 all property/global coefficientFriction peratomtypepair 3 {1} {1} {2} "
                     "{1} {1} {2} {2} {2} {2}\n"
                     "fix m5 all property/global cohesionEnergyDensity peratomtypepair 3 {3} {3} 0 "
                     "{3} {3} 0 0 0 0\n",
                     press.young_modulus, f, w, c);
}

/// Large grains first, each class in a step of its own.
std::string filling(GrainPress const& press) {
  std::string text =
      fmt::format("region bed cylinder z 0 0 {} 0 {} units box\n", 0.5 * stated_bore, fill_height);
  int n = 0;
  for (auto const& [type, density, diameter, number] : classes) {
    text +=
        fmt::format("fix t{0} all particletemplate/sphere {1} atom_type {2} density constant {3} "
                    "radius constant {4}\n"
                    "fix d{0} all particledistribution/discrete {5} 1 t{0} 1.0\n",
                    n, prime_seed(press.packing, 3 * n), type, density, 0.5 * diameter,
                    prime_seed(press.packing, 3 * n + 1));
    ++n;
  }
  int inside = 0; // the peer counts all grains that are there
  for (int k = 0; k < n; ++k)
    text += fmt::format("fix i{0} all insert/pack seed {1} distributiontemplate d{0} maxattempt "
                        "5000 insert_every once "
                        "overlapcheck yes all_in yes particles_in_region {2} region bed\nrun 1\n",
                        k, prime_seed(press.packing, 3 * k + 2), inside += classes[k].number);
  // A bed that is not whole is no bed: without curves the caller says that the simulation failed.
  return text + fmt::format("variable n_grains equal atoms\nif \"${{n_grains}} != {}\" then quit\n",
                            inside);
}

/// A move of the upper punch; `step` and `time` go on with it.
std::string move(double from, double to, double dt, long& step, double& time) {
  auto const n_steps = static_cast<long>(std::ceil(std::abs(to - from) / speed / dt));
  double const velocity = (to > from ? 1.0 : -1.0) * speed;
  auto const text = fmt::format(
      "variable now equal {0}+(step-{1})*{2}\nvariable height equal {3}+({4})*(step-{1})*{2}\n"
      "fix motion all move/mesh mesh upper linear 0 0 {4}\n"
      "fix record all print {5} \"${{now}} ${{height}} ${{force_upper}} ${{force_lower}} "
      "${{wall}}\" "
      "append curves.txt screen no title \"\"\n"
      "run {6}\nunfix record\nunfix motion\n",
      time, step, dt, from, velocity, std::lround(0.25e-3 / dt), n_steps);
  step += n_steps;
  time += static_cast<double>(n_steps) * dt;
  return text;
}

/// Faces up; every side passes the axis far outside the bore.
std::string plate(double z) {
  double const reach = 2.0 * half_width;
  return fmt::format("solid plate\nfacet normal 0 0 1\nouter loop\nvertex {0} {1} {2}\n"
                     "vertex {3} {1} {2}\nvertex 0 {4} {2}\nendloop\nendfacet\nendsolid plate\n",
                     -2.0 * reach, -reach, z, 2.0 * reach, 2.0 * reach);
}

} // namespace

std::vector<std::pair<std::string, std::string>> deck_of(GrainPress const& press) {
  if (!press.more.empty())
    throw std::invalid_argument(fmt::format(
        "the other code has no entry '{}'. Is the cause one of its own?", press.more.front()));
  // A tenth of the Rayleigh time of 1.2 mm alumina at 250 MPa, 11.25e-6 s. At a fifth the same bed
  // bears 8 % less.
  double const dt = 0.1 * 11.25e-6 * std::sqrt(250e6 / press.young_modulus);
  long step = static_cast<long>(std::size(classes)); // one each for the filling
  double time = 0.0;
  auto const closing = move(fill_height, press.end_gap, dt, step, time);
  std::string const deck =
      fmt::format("atom_style granular\natom_modify map array\nboundary m m m\nnewton off\n"
                  "communicate single vel yes\nunits si\n"
                  "region box block {0} {1} {0} {1} {0} {2} units box\ncreate_box 3 box\n",
                  -half_width, half_width, fill_height + half_width) +
      "neighbor 2e-4 bin\nneigh_modify delay 0\n" + materials(press) +
      // `on` is the net friction limit, the preset of the quick case.
      "pair_style gran model hertz tangential history cohesion sjkr2 tangential_reduce on\n"
      "pair_coeff * *\n" +
      fmt::format("timestep {}\nfix gravity all gravity 9.81 vector 0 0 -1\n"
                  "fix lower all mesh/surface/stress file lower.stl type 3\n"
                  "fix upper all mesh/surface/stress file upper.stl type 3\n"
                  "fix punches all wall/gran model hertz tangential history mesh n_meshes 2 "
                  "meshes lower upper\n"
                  "fix bore all wall/gran model hertz tangential history primitive type 3 "
                  "zcylinder {} 0 0 store_force yes\n"
                  "fix integrate all nve/sphere\n",
                  dt, 0.5 * stated_bore) +
      filling(press) +
      "variable outward atom -(x*f_force_bore[1]+y*f_force_bore[2])/(sqrt(x*x+y*y)+1e-9)\n"
      "compute wall all reduce sum v_outward\nvariable wall equal c_wall\n"
      "variable force_upper equal f_upper[3]\nvariable force_lower equal -f_lower[3]\n"
      "thermo_style custom step atoms ke cpu\nthermo 5000\nthermo_modify lost error\n" +
      closing + move(press.end_gap, open_gap, dt, step, time);
  return {{"in.press", deck}, {"lower.stl", plate(0.0)}, {"upper.stl", plate(fill_height)}};
}

} // namespace hidden
