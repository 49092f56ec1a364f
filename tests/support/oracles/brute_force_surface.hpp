#pragma once

#include "dem/surface/triangle_surface.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

/// Contacts of a grain with flat faces by brute force: every triangle is measured, and the rules
/// are stated by what they mean, with neither topology nor a search structure. For polyhedra, whose
/// patches are their flats.
namespace dem::oracle {

inline Vec3 closest_on_segment(Vec3 const& a, Vec3 const& b, Vec3 const& x) {
  double const s = (x - a).dot(b - a) / (b - a).squaredNorm();
  return a + std::clamp(s, 0.0, 1.0) * (b - a);
}

struct Triangle {
  Vec3 a, b, c, normal;

  Triangle(TriangleSurface const& surface, std::size_t row)
      : a(surface.vertices[surface.triangles[row][0]]),
        b(surface.vertices[surface.triangles[row][1]]),
        c(surface.vertices[surface.triangles[row][2]]), normal((b - a).cross(c - a).normalized()) {}

  bool is_above(Vec3 const& x) const { // its foot lies within all three sides
    return (b - a).cross(x - a).dot(normal) >= 0.0 && (c - b).cross(x - b).dot(normal) >= 0.0 &&
           (a - c).cross(x - c).dot(normal) >= 0.0;
  }

  Vec3 closest(Vec3 const& x) const {
    if (is_above(x))
      return x - (x - a).dot(normal) * normal;
    Vec3 best = closest_on_segment(a, b, x);
    for (auto const& other : {closest_on_segment(b, c, x), closest_on_segment(c, a, x)})
      if ((other - x).norm() < (best - x).norm())
        best = other;
    return best;
  }

  bool touches(Vec3 const& x) const { return (closest(x) - x).norm() < 1e-12; }
};

struct Contact {
  Vec3 point;
  double distance; ///< [m], negative behind the face
  std::uint32_t patch;
};

class BruteForceSurface {
public:
  /// @param patch_of  patch of each triangle
  BruteForceSurface(TriangleSurface const& surface, std::vector<std::uint32_t> patch_of)
      : patch_of_(std::move(patch_of)) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      triangles_.emplace_back(surface, t);
    for (auto const patch : patch_of_)
      n_patches_ = std::max(n_patches_, patch + 1);
  }

  /// A patch's nearest point counts if no triangle that touches it comes nearer to the centre next
  /// to it: when the centre has come almost all the way, the point is still the nearest one of
  /// each. Two patches with one nearest point share it. Behind the faces only the least deep
  /// counts, and none that is seen through another face.
  std::vector<Contact> find(Vec3 const& centre, double reach) const {
    std::vector<Contact> contacts;
    for (std::uint32_t patch = 0; patch < n_patches_; ++patch) {
      auto const nearest = nearest_on(patch, centre);
      double const distance = (nearest.point - centre).norm();
      if (distance > reach)
        continue;
      Vec3 const close_by = nearest.point + 1e-3 * (centre - nearest.point);
      bool const is_undercut = std::ranges::any_of(triangles_, [&](Triangle const& triangle) {
        return triangle.touches(nearest.point) &&
               (triangle.closest(close_by) - close_by).norm() <
                   (close_by - nearest.point).norm() * (1.0 - 1e-9);
      });
      if (is_undercut)
        continue;
      bool const is_shared = std::ranges::any_of(contacts, [&](Contact const& c) {
        return (c.point - nearest.point).norm() < 1e-7 * distance;
      });
      if (!is_shared)
        contacts.push_back({nearest.point, nearest.is_behind ? -distance : distance, patch});
    }
    std::erase_if(contacts,
                  [&](Contact const& c) { return c.distance < 0.0 && is_hidden(c, centre); });
    double least_deep = -std::numeric_limits<double>::infinity();
    for (auto const& c : contacts)
      if (c.distance < 0.0)
        least_deep = std::max(least_deep, c.distance);
    std::erase_if(contacts, [&](Contact const& c) { return c.distance < least_deep; });
    return contacts;
  }

private:
  struct Nearest {
    Vec3 point;
    bool is_behind; ///< the centre stands behind every face that touches the point
  };

  Nearest nearest_on(std::uint32_t patch, Vec3 const& centre) const {
    Vec3 best = Vec3::Constant(std::numeric_limits<double>::infinity());
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (patch_of_[t] != patch)
        continue;
      Vec3 const point = triangles_[t].closest(centre);
      if ((point - centre).norm() < (best - centre).norm())
        best = point;
    }
    bool is_behind = true;
    for (auto const& triangle : triangles_)
      if (triangle.touches(best) && (centre - best).dot(triangle.normal) >= 0.0)
        is_behind = false;
    return {best, is_behind};
  }

  bool is_hidden(Contact const& contact, Vec3 const& centre) const {
    Vec3 const way = centre - contact.point;
    return std::ranges::any_of(triangles_, [&](Triangle const& t) {
      double const speed = t.normal.dot(way);
      if (speed <= 1e-9 * way.norm())
        return false;
      double const when = t.normal.dot(t.a - contact.point) / speed;
      return when > 1e-9 && when < 1.0 && t.is_above(contact.point + when * way);
    });
  }

  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> patch_of_;
  std::uint32_t n_patches_ = 0;
};

} // namespace dem::oracle
