#include "continuum/tool/surface_trace.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/quote.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace continuum {

namespace {
// Lagrange polynomials on 0, 1/2, 1.
Eigen::Vector3d lagrange(double x) {
  return {(1.0 - x) * (1.0 - 2.0 * x), 4.0 * x * (1.0 - x), x * (2.0 * x - 1.0)};
}
Eigen::Vector3d lagrange_derivative(double x) {
  return {4.0 * x - 3.0, 4.0 - 8.0 * x, 4.0 * x - 1.0};
}

Eigen::Matrix<double, 9, 1> product(Eigen::Vector3d const& along_xi,
                                    Eigen::Vector3d const& along_eta) {
  Eigen::Matrix<double, 9, 1> values;
  for (int j = 0; j < 3; ++j)
    values.segment<3>(3 * j) = along_eta[j] * along_xi;
  return values;
}

Eigen::Matrix<double, 3, 9> nodes_of(SurfaceTrace const& trace, std::uint32_t face) {
  Eigen::Matrix<double, 3, 9> positions;
  for (int a = 0; a < 9; ++a)
    positions.col(a) = trace.positions.col(trace.faces[face].nodes[a]);
  return positions;
}

// dx/dxi x dx/deta: outward, its length the area element.
Eigen::Vector3d area_vector(Eigen::Matrix<double, 3, 9> const& nodes, double xi, double eta) {
  Eigen::Matrix<double, 3, 2> const tangents = nodes * face_shape_gradient(xi, eta);
  return tangents.col(0).cross(tangents.col(1));
}

// 3 x 3 Gauss: N (2 in each direction) times the area vector (3) has degree 5, which it integrates.
template <class Visit> void for_each_gauss_point(Visit visit, int cuts = 1) {
  double const off = 0.5 * std::sqrt(0.6), h = 1.0 / cuts;
  std::array<double, 3> const x = {0.5 - off, 0.5, 0.5 + off};
  std::array<double, 3> const w = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  for (int i = 0; i < 3 * cuts; ++i)
    for (int j = 0; j < 3 * cuts; ++j)
      visit((i / 3 + x[i % 3]) * h, (j / 3 + x[j % 3]) * h, w[i % 3] * w[j % 3] * h * h);
}

// The part of the chord's error that is square to the chord: sliding along it changes no shape.
double chord_error(Eigen::Matrix<double, 3, 9> const& nodes, Eigen::Vector2d const& from,
                   Eigen::Vector2d const& to) {
  auto const at = [&](Eigen::Vector2d const& p) -> Eigen::Vector3d {
    return nodes * face_shape(p.x(), p.y());
  };
  Eigen::Vector3d const a = at(from), b = at(to), off = at(0.5 * (from + to)) - 0.5 * (a + b);
  Eigen::Vector3d const along = (b - a).normalized();
  return (off - off.dot(along) * along).norm();
}

double largest_chord_error(SurfaceTrace const& trace, int k) {
  double largest = 0.0;
  double const h = 1.0 / k;
  for (std::uint32_t face = 0; face < trace.faces.size(); ++face) {
    auto const nodes = nodes_of(trace, face);
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i <= k; ++i) {
        Eigen::Vector2d const here(i * h, j * h);
        if (i < k)
          largest = std::max(largest, chord_error(nodes, here, here + Eigen::Vector2d(h, 0.0)));
        if (j < k)
          largest = std::max(largest, chord_error(nodes, here, here + Eigen::Vector2d(0.0, h)));
        if (i < k && j < k)
          largest = std::max(largest, chord_error(nodes, here, here + Eigen::Vector2d(h, h)));
      }
  }
  return largest;
}

// Numbers the points of the k x k grid on every face once, also where faces meet: a corner is known
// by its node, a point of an edge by the edge's corners and its place between them.
class VertexNumbers {
public:
  VertexNumbers(SurfaceTrace const& trace, int k) : trace_(trace), k_(k) {}

  std::uint32_t operator()(std::uint32_t face, int i, int j, TraceTriangles& out) {
    auto const [found, is_new] = numbers_.try_emplace(key(face, i, j), out.vertices.size());
    if (is_new) {
      double const xi = static_cast<double>(i) / k_, eta = static_cast<double>(j) / k_;
      out.vertices.push_back(trace_.position(face, xi, eta));
      out.places.push_back({face, xi, eta});
    }
    return found->second;
  }

private:
  using Key = std::array<std::int64_t, 4>; // kind, then what names the point

  Key key(std::uint32_t face, int i, int j) const {
    auto const& nodes = trace_.faces[face].nodes;
    bool const i_ends = i == 0 || i == k_, j_ends = j == 0 || j == k_;
    int const column = i == 0 ? 0 : 2, row = j == 0 ? 0 : 2;
    if (i_ends && j_ends)
      return {0, nodes[3 * row + column], 0, 0};
    if (j_ends)
      return edge(nodes[3 * row], nodes[3 * row + 2], i);
    if (i_ends)
      return edge(nodes[column], nodes[6 + column], j);
    return {2, face, i, j};
  }
  Key edge(std::int64_t from, std::int64_t to, int step) const {
    return from < to ? Key{1, from, to, step} : Key{1, to, from, k_ - step};
  }

  SurfaceTrace const& trace_;
  int k_;
  std::map<Key, std::uint32_t> numbers_;
};
} // namespace

Eigen::Matrix<double, 9, 1> face_shape(double xi, double eta) {
  return product(lagrange(xi), lagrange(eta));
}

Eigen::Matrix<double, 9, 2> face_shape_gradient(double xi, double eta) {
  Eigen::Matrix<double, 9, 2> gradient;
  gradient.col(0) = product(lagrange_derivative(xi), lagrange(eta));
  gradient.col(1) = product(lagrange(xi), lagrange_derivative(eta));
  return gradient;
}

Eigen::Vector3d SurfaceTrace::position(std::uint32_t face, double xi, double eta) const {
  return nodes_of(*this, face) * face_shape(xi, eta);
}

Eigen::Vector3d SurfaceTrace::normal(std::uint32_t face, double xi, double eta) const {
  return area_vector(nodes_of(*this, face), xi, eta).normalized();
}

double SurfaceTrace::area() const {
  double sum = 0.0;
  for (std::uint32_t face = 0; face < faces.size(); ++face)
    for_each_gauss_point(
        [&, face_nodes = nodes_of(*this, face)](double xi, double eta, double weight) {
          sum += weight * area_vector(face_nodes, xi, eta).norm();
        });
  return sum;
}

Eigen::Matrix3Xd SurfaceTrace::pressure_loads(double pressure) const {
  Eigen::Matrix3Xd loads = Eigen::Matrix3Xd::Zero(3, positions.cols());
  for (std::uint32_t face = 0; face < faces.size(); ++face)
    for_each_gauss_point(
        [&, face_nodes = nodes_of(*this, face)](double xi, double eta, double weight) {
          Eigen::Vector3d const force = -pressure * weight * area_vector(face_nodes, xi, eta);
          auto const shape = face_shape(xi, eta);
          for (int a = 0; a < 9; ++a)
            loads.col(faces[face].nodes[a]) += shape[a] * force;
        });
  return loads;
}

Eigen::Matrix3Xd SurfaceTrace::traction_loads(Traction const& traction, int cuts) const {
  VALIDATE(cuts > 0, "traction on faces cut " + std::to_string(cuts) +
                         " times (at least one part is integrated). Leave the number out?");
  Eigen::Matrix3Xd loads = Eigen::Matrix3Xd::Zero(3, positions.cols());
  for (std::uint32_t face = 0; face < faces.size(); ++face)
    for_each_gauss_point(
        [&, face_nodes = nodes_of(*this, face)](double xi, double eta, double weight) {
          auto const shape = face_shape(xi, eta);
          Eigen::Vector3d const area = area_vector(face_nodes, xi, eta);
          Eigen::Vector3d const force =
              weight * area.norm() * traction(face_nodes * shape, area.normalized());
          for (int a = 0; a < 9; ++a)
            loads.col(faces[face].nodes[a]) += shape[a] * force;
        },
        cuts);
  return loads;
}

TraceTriangles SurfaceTrace::triangulate(double tolerance) const {
  VALIDATE(std::isfinite(tolerance) && tolerance > 0.0,
           "chord tolerance = " + quote(tolerance) +
               " m (the distance of triangles from the surface is positive). Is the unit missing?");
  int k = 1;
  while (k <= 64 && largest_chord_error(*this, k) > tolerance)
    ++k;
  VALIDATE(k <= 64, "chord tolerance = " + quote(tolerance) +
                        " m needs more than 64 x 64 cuts of a face (limit of the triangulation). "
                        "Make the cells smaller or the tolerance larger?");

  TraceTriangles out{.per_edge = k};
  VertexNumbers number(*this, k);
  for (std::uint32_t face = 0; face < faces.size(); ++face)
    for (int j = 0; j < k; ++j)
      for (int i = 0; i < k; ++i) {
        std::uint32_t const a = number(face, i, j, out), b = number(face, i + 1, j, out),
                            c = number(face, i + 1, j + 1, out), d = number(face, i, j + 1, out);
        out.triangles.push_back({a, b, c});
        out.triangles.push_back({a, c, d});
        out.faces.insert(out.faces.end(), 2, face);
      }
  return out;
}

} // namespace continuum
