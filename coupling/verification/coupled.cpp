#include "coupling/case_file.hpp"
#include "coupling/elastic/face_locator.hpp"
#include "coupling/elastic/session.hpp"
#include "coupling/elastic/yielding_tool.hpp"
#include "coupling/press_frame.hpp"
#include "coupling/verification/benchmarks.hpp"
#include "coupling/verification/closed_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

/// What grains and tools hand each other.
namespace coupling::verification {
namespace {

constexpr double bore_radius = 11.025e-3, punch_length = 20e-3; // [m]
constexpr double young = 200e9, poisson = 0.3;                  // [Pa], [1]
constexpr double pressure = 65.72e6;                            // [Pa], the seed's at 25 095 N

/// Steel die and punches of 20 mm whose sides the die guides.
std::vector<ElasticPair> guided_tools() {
  ensure_session();
  std::string const at = "Deformable tools/";
  std::string const entries[] = {"Mode=one_way", "Tooling/Punch length=20 mm",
                                 at + "Punch support=guided", at + "Young's modulus=200 GPa",
                                 at + "Poisson's ratio=0.3"};
  return make_yielding_tools(parse_case("set Title = Guided punches\n", "guided", entries));
}

/// Random forces at random points of die and punch: what is lost on the way to the nodes, over the
/// sum of magnitudes.
std::vector<Benchmark> transfer() {
  TransferErrors worst;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (ElasticPair const& tool : guided_tools()) {
    ElasticSurface& surface = *tool.body->surface;
    std::vector<dem::WallImpulse> impulses;
    for (int k = 0; k < 400; ++k) {
      auto const face = static_cast<std::uint32_t>(random() % surface.trace().faces.size());
      impulses.push_back({0,
                          {face, unit(random), unit(random)},
                          {unit(random) - 0.5, unit(random) - 0.5, unit(random)}});
    }
    Eigen::Matrix3Xd velocity(3, surface.trace().positions.cols());
    for (double& v : velocity.reshaped())
      v = unit(random) - 0.5;
    surface.set_course(velocity, velocity, 1.0);
    auto const found = surface.errors(impulses, 0, surface.nodal(impulses, 0));
    worst = {std::max(worst.force, found.force), std::max(worst.moment, found.moment),
             std::max(worst.power, found.power)};
  }
  char const* const source = "one set of shape functions both ways";
  return {compare("transfer/force", 0.0, worst.force, 1e-12, source),
          compare("transfer/moment", 0.0, worst.moment, 1e-12, source),
          compare("transfer/power", 0.0, worst.power, 1e-12, source)};
}

/// A layer of equal spheres in rings presses a punch that its die guides: it
/// shortens as an oedometer does, and two of their spacings below the face it does not know them
/// apart (with cells of half the spacing).
std::vector<Benchmark> layer_on_punch() {
  ensure_session();
  constexpr int n_rings = 3, n_spheres = 1 + 3 * n_rings * (n_rings + 1);
  double const spacing = bore_radius * std::sqrt(pi / n_spheres); // 3 mm
  continuum::PunchShape const shape{.radius = bore_radius, .length = punch_length};
  auto supports = continuum::Supports::clamped("back");
  supports.surfaces.push_back({"side", {true, true, false}});
  continuum::ElasticTool const punch(
      continuum::ToolMesh::punch(shape, continuum::cells_of_size(shape, 0.5 * spacing)),
      {{young, poisson}}, supports);
  ElasticSurface const face(punch.mesh().trace("face"), dem::Vec3::Zero(), {});
  FaceLocator const locator(face.trace());
  std::vector<dem::WallImpulse> loads; // over one second
  for (int ring = 0, inside = 0; ring <= n_rings; ++ring) {
    int const n = std::max(6 * ring, 1); // each has the same share of the face
    double const middle = ring == 0 ? 0.0 : inside + 0.5 * n;
    double const r = bore_radius * std::sqrt(middle / n_spheres);
    inside += n;
    for (int k = 0; k < n; ++k) {
      double const angle = 2.0 * pi * k / n;
      loads.push_back({0,
                       locator.nearest({r * std::cos(angle), r * std::sin(angle), 0.0}).place,
                       {0.0, 0.0, -pressure * face.trace().area() / n_spheres}});
    }
  }
  auto const u = punch.solve(punch.spread(face.trace(), face.nodal(loads, 0))).displacement;
  double deviation = 0.0;
  for (auto const& point : punch.stress_in_cells(u))
    if (point.position.z() < -2.0 * spacing)
      deviation = std::max(deviation, std::abs(point.stress(2, 2) / pressure + 1.0));
  auto const& nodes = face.trace().nodes;
  auto const weights = face.trace().pressure_loads(1.0);
  double retreat = 0.0;
  for (std::size_t a = 0; a < nodes.size(); ++a)
    retreat += weights.col(static_cast<Eigen::Index>(a)).dot(u.col(nodes[a])) / face.trace().area();
  double const exact =
      pressure * punch_length * (1.0 + poisson) * (1.0 - 2.0 * poisson) / (young * (1.0 - poisson));
  return {compare("layer_on_punch/retreat", exact, retreat, 1e-2,
                  "oedometer, p H (1 + nu)(1 - 2 nu) / (E (1 - nu))"),
          compare("layer_on_punch/stress_two_spacings_below", 0.0, deviation, 0.05,
                  "Saint-Venant: uniform, -p")};
}

/// A Hertzian bed and the press frame in series: the force when the machine, still moving, reaches
/// its end, against the root of  F = K (h - c - D(F))^(3/2).
std::vector<Benchmark> press_train() {
  constexpr double bed_height = 10e-3, commanded_end = 9e-3; // [m]
  constexpr double bed = 1e8, speed = 0.2, dt = 3e-7;        // [N/m^(3/2)], [m/s], [s]
  auto const bed_force = [](double gap) {
    return bed * std::pow(std::max(bed_height - gap, 0.0), 1.5);
  };
  std::vector<Benchmark> rows;
  for (double const number : {0.01, 0.1, 0.5, 1.0, 2.0}) {
    // Of the bed's slope 3/2 K sqrt(h - c) where a rigid machine would stop.
    double const slope = 1.5 * bed * std::sqrt(bed_height - commanded_end);
    FrameLaw const law{.stiffness = slope / number};
    PressFrame frame(law);
    double commanded = bed_height, gap = bed_height;
    while (commanded > commanded_end) {
      double const move = std::min(speed * dt, commanded - commanded_end);
      commanded -= move;
      gap += dt * frame.speed() - move;
      frame.step_done(bed_force(gap), gap, dt);
    }
    double low = commanded_end, high = bed_height;
    for (int k = 0; k < 100; ++k) {
      double const middle = 0.5 * (low + high);
      (commanded_end + law.deflection(bed_force(middle)) > middle ? low : high) = middle;
    }
    rows.push_back(compare(fmt::format("press_train/number_{}", number), bed_force(low),
                           bed_force(gap), 5e-3, "bed and spring in series, bisection"));
  }
  return rows;
}

} // namespace

std::vector<Experiment> coupled_experiments() {
  return {{"transfer", transfer}, {"layer_on_punch", layer_on_punch}, {"press_train", press_train}};
}

} // namespace coupling::verification
