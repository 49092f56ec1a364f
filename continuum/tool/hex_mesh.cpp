#include "continuum/tool/hex_mesh.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/quote.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace continuum {

namespace {
using std::numbers::pi;

void validate_length(char const* what, double value) {
  VALIDATE(std::isfinite(value) && value > 0.0,
           std::string(what) + " = " + quote(value) + " m (a length is positive). Is it misspelt?");
}

void validate_larger(char const* what, double value, char const* than, double smaller) {
  VALIDATE(std::isfinite(value) && value > smaller,
           std::string(what) + " = " + quote(value) + " m is not beyond the " + than + " = " +
               quote(smaller) + " m (no wall is left between). Are the two exchanged?");
}

void validate_count(char const* what, int value, int multiple) {
  VALIDATE(value > 0 && value <= 4096 && value % multiple == 0,
           std::string("cells ") + what + " = " + std::to_string(value) + " (a multiple of " +
               std::to_string(multiple) + ", up to 4096). Take " +
               std::to_string(std::clamp((value + multiple - 1) / multiple, 1, 4096 / multiple) *
                              multiple) +
               "?");
}

void validate_growth(double growth) {
  VALIDATE(growth >= 0.01 && growth <= 100.0,
           "growth of cells = " + quote(growth) +
               " (between 0.01 and 100, or cells degenerate). 1 makes them equal?");
}

// Cells of a target size at the start of a graded length: the mean is that times (growth + 1) / 2.
int count_for(double length, double size, double growth) {
  return std::max(2, static_cast<int>(std::ceil(length / (size * 0.5 * (1.0 + growth)))));
}

int around_for(double radius, double size, int multiple) {
  int const wanted = static_cast<int>(std::ceil(2.0 * pi * radius / size / multiple)) * multiple;
  return std::max(16, wanted);
}

void validate_size(double size) {
  VALIDATE(std::isfinite(size) && size > 0.0,
           "element size = " + quote(size) + " m (a size is positive). Is the unit missing?");
}
} // namespace

DieCells cells_of_size(DieShape const& shape, double size) {
  validate_size(size);
  DieCells cells;
  cells.around = around_for(shape.bore_radius, size, 4);
  cells.through_wall = count_for(shape.outer_radius - shape.bore_radius, size, cells.growth);
  if (shape.ring_radius)
    cells.through_ring =
        count_for(*shape.ring_radius - shape.outer_radius, size * cells.growth, 1.0);
  cells.along = count_for(shape.height, size, 1.0);
  return cells;
}

PunchCells cells_of_size(PunchShape const& shape, double size) {
  validate_size(size);
  PunchCells cells;
  cells.around = around_for(shape.radius, size, 8);
  cells.rings = count_for(0.4 * shape.radius, size, 1.0);
  cells.along = count_for(shape.length, size, cells.growth);
  return cells;
}

std::vector<double> graded(double from, double to, int n, double growth) {
  std::vector<double> points(n + 1, from);
  double const ratio = n > 1 ? std::pow(growth, 1.0 / (n - 1)) : 1.0;
  double size = 1.0;
  for (int i = 1; i <= n; ++i, size *= ratio)
    points[i] = points[i - 1] + size;
  double const scale = (to - from) / (points[n] - from);
  for (double& point : points)
    point = from + (point - from) * scale;
  points[n] = to; // to the bit: named radii are exact
  return points;
}

HexMesh mesh_die(DieShape const& shape, DieCells const& cells) {
  validate_length("die: bore radius", shape.bore_radius);
  validate_larger("die: outer radius", shape.outer_radius, "bore radius", shape.bore_radius);
  validate_length("die: height", shape.height);
  if (shape.ring_radius)
    validate_larger("die: ring radius", *shape.ring_radius, "outer radius", shape.outer_radius);
  validate_count("around", cells.around, 4);
  validate_count("through the wall", cells.through_wall, 1);
  validate_count("along", cells.along, 1);
  validate_growth(cells.growth);

  std::vector<double> radii =
      graded(shape.bore_radius, shape.outer_radius, cells.through_wall, cells.growth);
  if (shape.ring_radius) {
    validate_count("through the ring", cells.through_ring, 1);
    auto const ring = graded(shape.outer_radius, *shape.ring_radius, cells.through_ring, 1.0);
    radii.insert(radii.end(), ring.begin() + 1, ring.end());
  }
  std::vector<double> const heights = graded(0.0, shape.height, cells.along, 1.0);
  unsigned const n_r = radii.size() - 1, n_t = cells.around, n_z = cells.along;
  auto const at = [&](unsigned r, unsigned t, unsigned z) {
    return (z * n_t + t % n_t) * (n_r + 1) + r;
  };

  HexMesh mesh{.surfaces = {"bore", "outer", "bottom", "top"}};
  for (unsigned z = 0; z <= n_z; ++z)
    for (unsigned t = 0; t < n_t; ++t)
      for (unsigned r = 0; r <= n_r; ++r) {
        double const angle = 2.0 * pi * t / n_t;
        mesh.vertices.emplace_back(radii[r] * std::cos(angle), radii[r] * std::sin(angle),
                                   heights[z]);
      }
  for (unsigned z = 0; z < n_z; ++z)
    for (unsigned t = 0; t < n_t; ++t)
      for (unsigned r = 0; r < n_r; ++r) {
        mesh.cells.push_back({at(r, t, z), at(r + 1, t, z), at(r, t + 1, z), at(r + 1, t + 1, z),
                              at(r, t, z + 1), at(r + 1, t, z + 1), at(r, t + 1, z + 1),
                              at(r + 1, t + 1, z + 1)});
        mesh.regions.push_back(r < static_cast<unsigned>(cells.through_wall) ? 0 : 1);
      }
  for (unsigned t = 0; t < n_t; ++t) {
    for (unsigned z = 0; z < n_z; ++z)
      for (unsigned const end : {0u, 1u}) {
        unsigned const r = end * n_r;
        mesh.boundary.push_back(
            {{at(r, t, z), at(r, t + 1, z), at(r, t, z + 1), at(r, t + 1, z + 1)}, end});
      }
    for (unsigned r = 0; r < n_r; ++r)
      for (unsigned const end : {0u, 1u}) {
        unsigned const z = end * n_z;
        mesh.boundary.push_back(
            {{at(r, t, z), at(r + 1, t, z), at(r, t + 1, z), at(r + 1, t + 1, z)}, 2 + end});
      }
  }
  mesh.pins = {{at(n_r, 0, 0), 1}, {at(n_r, n_t / 4, 0), 0}, {at(n_r, n_t / 2, 0), 1}};
  return mesh;
}

namespace {
// A disc of quadrilaterals: a rounded square of m x m cells, and rings of 4 m cells round it.
struct Disc {
  std::vector<Eigen::Vector2d> points;
  std::vector<std::array<unsigned, 4>> quads; // lexicographic, right-handed
  std::vector<unsigned> rim;                  // counter-clockwise from -45 degrees
};

// The elliptical map takes a square to a disc; half way to it, no corner of a cell is flat.
Eigen::Vector2d rounded_square(double x, double y) {
  Eigen::Vector2d const square(x, y);
  Eigen::Vector2d const disc(x * std::sqrt(1.0 - 0.5 * y * y), y * std::sqrt(1.0 - 0.5 * x * x));
  return 0.5 * (square + disc);
}

Disc mesh_disc(double radius, unsigned m, unsigned n_rings) {
  double const square_half_width = 0.55 * radius;
  Disc disc;
  // Tangents of equal angles: points of the square's rim face those of the circle.
  auto const spaced = [&](unsigned i) { return std::tan(pi / 4.0 * (2.0 * i / m - 1.0)); };
  auto const inner = [&](unsigned i, unsigned j) { return j * (m + 1) + i; };
  for (unsigned j = 0; j <= m; ++j)
    for (unsigned i = 0; i <= m; ++i)
      disc.points.push_back(square_half_width * rounded_square(spaced(i), spaced(j)));
  for (unsigned j = 0; j < m; ++j)
    for (unsigned i = 0; i < m; ++i)
      disc.quads.push_back({inner(i, j), inner(i + 1, j), inner(i, j + 1), inner(i + 1, j + 1)});

  std::vector<unsigned> loop;
  for (unsigned i = 0; i < m; ++i)
    loop.push_back(inner(m, i));
  for (unsigned i = 0; i < m; ++i)
    loop.push_back(inner(m - i, m));
  for (unsigned i = 0; i < m; ++i)
    loop.push_back(inner(0, m - i));
  for (unsigned i = 0; i < m; ++i)
    loop.push_back(inner(i, 0));
  std::vector<unsigned> const square_rim = loop;
  for (unsigned ring = 1; ring <= n_rings; ++ring) {
    std::vector<unsigned> next;
    double const out = static_cast<double>(ring) / n_rings;
    for (unsigned t = 0; t < 4 * m; ++t) {
      double const angle = pi / 2.0 * t / m - pi / 4.0;
      Eigen::Vector2d const rim = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      next.push_back(disc.points.size());
      Eigen::Vector2d const inside = disc.points[square_rim[t]];
      disc.points.push_back(ring == n_rings ? rim
                                            : Eigen::Vector2d((1.0 - out) * inside + out * rim));
    }
    for (unsigned t = 0; t < 4 * m; ++t) {
      unsigned const after = (t + 1) % (4 * m);
      disc.quads.push_back({loop[t], next[t], loop[after], next[after]});
    }
    loop = next;
  }
  disc.rim = loop;
  return disc;
}
} // namespace

HexMesh mesh_punch(PunchShape const& shape, PunchCells const& cells) {
  validate_length("punch: radius", shape.radius);
  validate_length("punch: length", shape.length);
  validate_count("around", cells.around, 8);
  validate_count("in rings", cells.rings, 1);
  validate_count("along", cells.along, 1);
  validate_growth(cells.growth);

  Disc const disc = mesh_disc(shape.radius, cells.around / 4, cells.rings);
  bool const is_lower = shape.place == PunchPlace::lower;
  std::vector<double> const heights =
      is_lower ? graded(-shape.length, 0.0, cells.along, 1.0 / cells.growth)
               : graded(0.0, shape.length, cells.along, cells.growth);
  unsigned const n_z = cells.along, n_disc = disc.points.size();
  unsigned const face_z = is_lower ? n_z : 0, back_z = n_z - face_z;

  HexMesh mesh{.surfaces = {"face", "side", "back"},
               .rounding = Rounding::on_round_surface,
               .round_surface = 1};
  for (double const height : heights)
    for (Eigen::Vector2d const& point : disc.points)
      mesh.vertices.emplace_back(point.x(), point.y(), height);
  for (unsigned z = 0; z < n_z; ++z)
    for (auto const& [a, b, c, d] : disc.quads) {
      unsigned const low = z * n_disc, high = low + n_disc;
      mesh.cells.push_back(
          {low + a, low + b, low + c, low + d, high + a, high + b, high + c, high + d});
    }
  mesh.regions.assign(mesh.cells.size(), 0);
  for (auto const& [a, b, c, d] : disc.quads) {
    unsigned const face = face_z * n_disc, back = back_z * n_disc;
    mesh.boundary.push_back({{face + a, face + b, face + c, face + d}, 0});
    mesh.boundary.push_back({{back + a, back + b, back + c, back + d}, 2});
  }
  for (unsigned z = 0; z < n_z; ++z)
    for (std::size_t t = 0; t < disc.rim.size(); ++t) {
      unsigned const a = z * n_disc + disc.rim[t],
                     b = z * n_disc + disc.rim[(t + 1) % disc.rim.size()];
      mesh.boundary.push_back({{a, b, a + n_disc, b + n_disc}, 1});
    }
  // The rim starts at -45 degrees, so an eighth of it further is the x axis.
  auto const rim_at = [&](int eighths) {
    return back_z * n_disc + disc.rim[eighths * cells.around / 8];
  };
  mesh.pins = {{rim_at(1), 1}, {rim_at(3), 0}, {rim_at(5), 1}};
  return mesh;
}

} // namespace continuum
