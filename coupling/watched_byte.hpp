#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>

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

/// A text that knows how far its parser has come.
class WatchedText {
public:
  explicit WatchedText(std::string_view text) : text_(text), counted_(text.data()) {}

  WatchedByte begin() { return {text_.data(), &furthest_}; }
  WatchedByte end() { return {text_.data() + text_.size(), &furthest_}; }

  /// The line, from 1, of what the parser has just understood: it has read one byte past a number,
  /// and just the quote that ends a text.
  int line() {
    char const* const end = furthest_ == nullptr ? counted_ : std::max(counted_, furthest_ - 1);
    line_ += static_cast<int>(std::count(counted_, end, '\n'));
    counted_ = end;
    return line_;
  }

private:
  std::string_view text_;
  char const* counted_;
  char const* furthest_ = nullptr;
  int line_ = 1;
};

} // namespace coupling
