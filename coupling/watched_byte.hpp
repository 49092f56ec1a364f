#pragma once

#include <cstddef>
#include <iterator>

namespace coupling {

/// Walks over a text and tells how far the parser has read, so that events can be given a line.
class WatchedByte {
public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = char const*;
  using reference = char const&;

  WatchedByte() = default;
  WatchedByte(char const* at, char const** furthest) : at_(at), furthest_(furthest) {}
  reference operator*() const { return *at_; }
  WatchedByte& operator++() {
    *furthest_ = ++at_;
    return *this;
  }
  WatchedByte operator++(int) {
    WatchedByte const before = *this;
    ++*this;
    return before;
  }
  bool operator==(WatchedByte const& other) const { return at_ == other.at_; }

private:
  char const* at_ = nullptr;
  char const** furthest_ = nullptr;
};

} // namespace coupling
