#include "continuum/tool/disc_mesh.hpp"

#include <cmath>
#include <numbers>

namespace continuum {

namespace {
using std::numbers::pi;

// The elliptical map takes a square to a disc; half way to it, no corner of a cell is flat.
Eigen::Vector2d rounded_square(double x, double y) {
  Eigen::Vector2d const square(x, y);
  Eigen::Vector2d const disc(x * std::sqrt(1.0 - 0.5 * y * y), y * std::sqrt(1.0 - 0.5 * x * x));
  return 0.5 * (square + disc);
}

// Corners are known; the sides are straight but for those given, the middle follows from the sides.
std::array<Eigen::Vector2d, 9> quad_nodes(Disc const& disc, std::array<unsigned, 4> const& quad) {
  std::array<Eigen::Vector2d, 9> nodes;
  for (int v = 0; v < 4; ++v)
    nodes[6 * (v / 2) + 2 * (v % 2)] = disc.points[quad[v]];
  nodes[1] = 0.5 * (nodes[0] + nodes[2]);
  nodes[3] = 0.5 * (nodes[0] + nodes[6]);
  nodes[5] = 0.5 * (nodes[2] + nodes[8]);
  nodes[7] = 0.5 * (nodes[6] + nodes[8]);
  nodes[4] = 0.5 * (nodes[3] + nodes[5]);
  return nodes;
}

Eigen::Vector2d on_circle(double radius, double quarter_turns) {
  double const angle = pi / 2.0 * quarter_turns - pi / 4.0;
  return radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

void add_square(Disc& disc, double half_width, unsigned m) {
  // Tangents of equal angles: points of the square's rim face those of the circle.
  auto const spaced = [&](unsigned i) { return std::tan(pi / 4.0 * (2.0 * i / m - 1.0)); };
  auto const at = [&](unsigned i, unsigned j) { return j * (m + 1) + i; };
  for (unsigned j = 0; j <= m; ++j)
    for (unsigned i = 0; i <= m; ++i)
      disc.points.push_back(half_width * rounded_square(spaced(i), spaced(j)));
  for (unsigned j = 0; j < m; ++j)
    for (unsigned i = 0; i < m; ++i) {
      disc.quads.push_back({at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
      disc.nodes.push_back(quad_nodes(disc, disc.quads.back()));
    }
  for (unsigned i = 0; i < m; ++i)
    disc.rim.push_back(at(m, i));
  for (unsigned i = 0; i < m; ++i)
    disc.rim.push_back(at(m - i, m));
  for (unsigned i = 0; i < m; ++i)
    disc.rim.push_back(at(0, m - i));
  for (unsigned i = 0; i < m; ++i)
    disc.rim.push_back(at(i, 0));
}

// A ring of cells from the present rim to `points`; `curve` may then bend the sides.
template <class Curve>
void add_ring(Disc& disc, std::vector<Eigen::Vector2d> const& points, Curve const& curve) {
  std::vector<unsigned> next;
  for (Eigen::Vector2d const& point : points) {
    next.push_back(disc.points.size());
    disc.points.push_back(point);
  }
  for (std::size_t t = 0; t < points.size(); ++t) {
    std::size_t const after = (t + 1) % points.size();
    disc.quads.push_back({disc.rim[t], next[t], disc.rim[after], next[after]});
    disc.nodes.push_back(quad_nodes(disc, disc.quads.back()));
    curve(t, disc.nodes.back());
  }
  disc.rim = next;
}
} // namespace

Disc mesh_disc(std::vector<double> const& circles, unsigned m, unsigned n_rings) {
  Disc disc;
  add_square(disc, 0.55 * circles[0], m);
  std::vector<unsigned> const square_rim = disc.rim;
  std::vector<Eigen::Vector2d> points(4 * m);
  auto const turns = [&](double t) { return t / m; };
  for (unsigned ring = 1; ring <= n_rings; ++ring) {
    double const out = static_cast<double>(ring) / n_rings;
    for (unsigned t = 0; t < 4 * m; ++t) {
      Eigen::Vector2d const circle = on_circle(circles[0], turns(t)),
                            inside = disc.points[square_rim[t]];
      points[t] = ring == n_rings ? circle : Eigen::Vector2d((1.0 - out) * inside + out * circle);
    }
    add_ring(disc, points, [&](unsigned t, auto& nodes) {
      if (ring < n_rings)
        return;
      nodes[5] = on_circle(circles[0], turns(t + 0.5));
      nodes[4] = 0.5 * (nodes[3] + nodes[5]);
    });
  }
  disc.n_inner = disc.quads.size();
  for (std::size_t c = 1; c < circles.size(); ++c) {
    double const middle = 0.5 * (circles[c - 1] + circles[c]);
    for (unsigned t = 0; t < 4 * m; ++t)
      points[t] = on_circle(circles[c], turns(t));
    add_ring(disc, points, [&](unsigned t, auto& nodes) {
      nodes[3] = on_circle(circles[c - 1], turns(t + 0.5));
      nodes[4] = on_circle(middle, turns(t + 0.5));
      nodes[5] = on_circle(circles[c], turns(t + 0.5));
    });
  }
  return disc;
}

} // namespace continuum
