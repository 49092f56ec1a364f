#include "dem/surface/box_tree.hpp"

#include <numeric>
#include <utility>

namespace dem {

BoxTree::BoxTree(std::span<Box const> boxes) : rows_(boxes.size()) {
  std::iota(rows_.begin(), rows_.end(), 0u);
  if (!boxes.empty())
    build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
  boxes_.reserve(boxes.size());
  for (auto const row : rows_)
    boxes_.push_back(boxes[row]);
}

void BoxTree::build(std::span<Box const> boxes, std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t leaf_size = 4;
  std::size_t const at = nodes_.size();
  Node node;
  for (auto k = begin; k < end; ++k)
    node.box.include(boxes[rows_[k]]);
  nodes_.push_back(node);
  if (end - begin <= leaf_size) {
    nodes_[at].first = begin;
    nodes_[at].count = end - begin;
    return;
  }
  Eigen::Index axis = 0;
  (node.box.high - node.box.low).maxCoeff(&axis);
  auto const middle = begin + (end - begin) / 2;
  // Equal centres fall back on the row, so that the tree is the same everywhere.
  auto const key = [&](std::uint32_t row) {
    return std::pair(boxes[row].low[axis] + boxes[row].high[axis], row);
  };
  std::ranges::nth_element(rows_.begin() + begin, rows_.begin() + middle, rows_.begin() + end, {},
                           key);
  build(boxes, begin, middle);
  nodes_[at].first = static_cast<std::uint32_t>(nodes_.size());
  build(boxes, middle, end);
}

} // namespace dem
