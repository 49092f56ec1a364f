#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace coupling {

/// A 64-bit checksum over bytes, a word of eight at a time; not cryptographic.
///   h <- mix(h xor word),  mix(h) = (h K) xor ((h K) >> 32),  K odd
/// Each step is a bijection in h and in the word, so two inputs of one length that differ in one
/// word never collide: a flipped byte is always seen. The length enters at the end, so trailing
/// zeros count. Usage: feed blocks in order; all but the last must be a multiple of eight bytes
/// long.
class Checksum {
public:
  void add(std::span<std::byte const> bytes) {
    static_assert(std::endian::native == std::endian::little, "files are little-endian");
    length_ += bytes.size();
    for (; bytes.size() >= sizeof(std::uint64_t); bytes = bytes.subspan(sizeof(std::uint64_t)))
      state_ = mix(state_ ^ word(bytes.first(sizeof(std::uint64_t))));
    if (!bytes.empty())
      state_ = mix(state_ ^ word(bytes));
  }

  std::uint64_t value() const { return mix(state_ ^ length_); }

private:
  static std::uint64_t word(std::span<std::byte const> bytes) {
    std::uint64_t w = 0;
    std::memcpy(&w, bytes.data(), bytes.size());
    return w;
  }

  static std::uint64_t mix(std::uint64_t h) {
    h *= 0x9e3779b97f4a7c15u; // 2^64 / golden ratio, odd: multiplication is invertible
    return h ^ (h >> 32);
  }

  std::uint64_t state_ =
      0x243f6a8885a308d3u; // digits of pi; any value but the zero of an all-zero file
  std::uint64_t length_ = 0;
};

} // namespace coupling
