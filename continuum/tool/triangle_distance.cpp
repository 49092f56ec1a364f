#include "continuum/tool/triangle_distance.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <limits>

namespace continuum {

namespace {
namespace bg = boost::geometry;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Point>;
using Entry = std::pair<Box, std::uint32_t>;

Point to_point(Eigen::Vector3d const& x) {
  return {x.x(), x.y(), x.z()};
}

std::array<Eigen::Vector3d, 3> triangle(Triangles const& surface, std::uint32_t t) {
  auto const& [a, b, c] = surface.corners[t];
  return {surface.vertices[a], surface.vertices[b], surface.vertices[c]};
}

class Search {
public:
  explicit Search(Triangles const& surface) : surface_(surface) {
    std::vector<Entry> entries;
    for (std::uint32_t t = 0; t < surface.corners.size(); ++t) {
      auto const [a, b, c] = triangle(surface, t);
      entries.emplace_back(
          Box(to_point(a.cwiseMin(b).cwiseMin(c)), to_point(a.cwiseMax(b).cwiseMax(c))), t);
    }
    tree_ = Tree(entries);
  }

  double distance(Eigen::Vector3d const& x) const {
    double least = std::numeric_limits<double>::infinity();
    auto const look_at = [&](Entry const& entry) {
      least = std::min(least, (closest_point(triangle(surface_, entry.second), x) - x).norm());
    };
    // The triangle of the nearest box bounds the distance; only boxes within it can hold a closer.
    // One ordered query for all would sort what it has found at every leaf.
    std::for_each(tree_.qbegin(bg::index::nearest(to_point(x), 1)), tree_.qend(), look_at);
    Eigen::Vector3d const reach = Eigen::Vector3d::Constant(least);
    Box const near(to_point(x - reach), to_point(x + reach));
    std::for_each(tree_.qbegin(bg::index::intersects(near)), tree_.qend(), look_at);
    return least;
  }

private:
  using Tree = bg::index::rtree<Entry, bg::index::rstar<8>>;
  Triangles const& surface_;
  Tree tree_;
};

double largest_distance(Triangles const& from, Search const& to) {
  double largest = 0.0;
  for (std::uint32_t t = 0; t < from.corners.size(); ++t) {
    auto const [a, b, c] = triangle(from, t);
    for (Eigen::Vector3d const& x :
         {a, b, c, Eigen::Vector3d(0.5 * (a + b)), Eigen::Vector3d(0.5 * (b + c)),
          Eigen::Vector3d(0.5 * (c + a)), Eigen::Vector3d((a + b + c) / 3.0)})
      largest = std::max(largest, to.distance(x));
  }
  return largest;
}
} // namespace

Eigen::Vector3d closest_point(std::array<Eigen::Vector3d, 3> const& triangle,
                              Eigen::Vector3d const& x) {
  auto const& [a, b, c] = triangle;
  Eigen::Vector3d const ab = b - a, ac = c - a;
  double const d1 = ab.dot(x - a), d2 = ac.dot(x - a);
  if (d1 <= 0.0 && d2 <= 0.0)
    return a;
  double const d3 = ab.dot(x - b), d4 = ac.dot(x - b);
  if (d3 >= 0.0 && d4 <= d3)
    return b;
  double const vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
    return a + d1 / (d1 - d3) * ab;
  double const d5 = ab.dot(x - c), d6 = ac.dot(x - c);
  if (d6 >= 0.0 && d5 <= d6)
    return c;
  double const vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
    return a + d2 / (d2 - d6) * ac;
  double const va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6)
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  double const sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

double largest_gap(Triangles const& one, Triangles const& other) {
  return std::max(largest_distance(one, Search(other)), largest_distance(other, Search(one)));
}

} // namespace continuum
