#pragma once

#include "dem/vec3.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace dem {

/// An axis-parallel box; empty when made.
struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void include(Vec3 const& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  void include(Box const& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  bool overlaps(Box const& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  /// Squared distance of a point from the box [m^2]; 0 inside.
  double squared_distance(Vec3 const& point) const {
    return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
  }
};

/// Boxes in a binary tree, split at the median: the search structure of tool surfaces. The order of
/// visits depends on the boxes alone, so results are the same on any number of threads.
class BoxTree {
public:
  BoxTree() = default;
  explicit BoxTree(std::span<Box const> boxes);

  /// Calls `measure(row)` for every box whose squared distance from `point` is at most `limit`,
  /// nearer branches first. `measure` may lower `limit` as it finds something nearer.
  template <class Measure>
  void near(Vec3 const& point, double const& limit, Measure&& measure) const;

  /// Calls `visit(row)` for every box that overlaps `region`.
  template <class Visit> void overlapping(Box const& region, Visit&& visit) const;

private:
  struct Node {
    Box box;
    std::uint32_t first =
        0; // leaf: first row in rows_; branch: second child (the first one follows its parent)
    std::uint32_t count = 0; // rows of a leaf; 0 marks a branch
  };
  static constexpr int deepest = 64;

  void build(std::span<Box const> boxes, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> rows_;
  std::vector<Box> boxes_; // in the order of rows_
};

template <class Measure>
void BoxTree::near(Vec3 const& point, double const& limit, Measure&& measure) const {
  if (nodes_.empty())
    return;
  std::uint32_t stack[deepest] = {0};
  for (int size = 1; size > 0;) {
    std::uint32_t const at = stack[--size];
    Node const& node = nodes_[at];
    if (node.box.squared_distance(point) > limit)
      continue;
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      if (boxes_[k].squared_distance(point) <= limit)
        measure(rows_[k]);
    if (node.count > 0)
      continue;
    bool const first_is_nearer = nodes_[at + 1].box.squared_distance(point) <=
                                 nodes_[node.first].box.squared_distance(point);
    stack[size++] = first_is_nearer ? node.first : at + 1;
    stack[size++] = first_is_nearer ? at + 1 : node.first;
  }
}

template <class Visit> void BoxTree::overlapping(Box const& region, Visit&& visit) const {
  if (nodes_.empty())
    return;
  std::uint32_t stack[deepest] = {0};
  for (int size = 1; size > 0;) {
    std::uint32_t const at = stack[--size];
    Node const& node = nodes_[at];
    if (!node.box.overlaps(region))
      continue;
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      if (boxes_[k].overlaps(region))
        visit(rows_[k]);
    if (node.count > 0)
      continue;
    stack[size++] = node.first;
    stack[size++] = at + 1;
  }
}

} // namespace dem
