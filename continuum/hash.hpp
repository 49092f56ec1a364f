#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace continuum {

/// 64-bit FNV-1a over everything fed to it, in order. It tells inputs apart; it is no seal against
/// forgery. Source: Fowler, Noll, Vo, draft-eastlake-fnv.
class Fnv {
public:
  Fnv& add_bytes(std::span<std::byte const> bytes) {
    for (std::byte const byte : bytes)
      value_ = (value_ ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3u;
    return *this;
  }
  template <class T>
  requires std::is_arithmetic_v<T> Fnv& add(T const& value) {
    return add_bytes(std::as_bytes(std::span(&value, 1)));
  }
  /// The length goes first, so that "ab", "c" and "a", "bc" differ.
  Fnv& add(std::string_view text) {
    add(text.size());
    return add_bytes(std::as_bytes(std::span(text)));
  }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

} // namespace continuum
