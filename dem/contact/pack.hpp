#pragma once

#include <cmath>
#include <cstddef>
#include <experimental/simd>
#include <type_traits>

/// The number types a contact law may be evaluated with: double, float, or a pack of either that
/// fills a vector register. Laws are written once as templates over the number type N and choose
/// between values with `select(condition, yes, no)` instead of branches.
namespace dem {

template <class T> using Pack = std::experimental::native_simd<T>;

template <class T> inline constexpr std::size_t pack_size = Pack<T>::size();

/// `condition ? yes : no`, lane by lane.
template <class T>
requires std::is_floating_point_v<T> T select(bool condition, T yes, T no) {
  return condition ? yes : no;
}
template <class T, class Abi>
std::experimental::simd<T, Abi> select(std::experimental::simd_mask<T, Abi> const& condition,
                                       std::experimental::simd<T, Abi> const& yes,
                                       std::experimental::simd<T, Abi> no) {
  where(condition, no) = yes;
  return no;
}

/// The larger of two numbers, lane by lane.
template <class N> N larger(N const& a, N const& b) {
  return select(a > b, a, b);
}

template <class T>
requires std::is_floating_point_v<T> T square_root(T x) {
  return std::sqrt(x);
}
template <class T, class Abi>
std::experimental::simd<T, Abi> square_root(std::experimental::simd<T, Abi> const& x) {
  return std::experimental::sqrt(x);
}

template <class T>
requires std::is_floating_point_v<T> T power(T x, T exponent) {
  return std::pow(x, exponent);
}
template <class T, class Abi>
std::experimental::simd<T, Abi> power(std::experimental::simd<T, Abi> const& x,
                                      std::experimental::simd<T, Abi> const& exponent) {
  return std::experimental::pow(x, exponent);
}

template <class T>
requires std::is_floating_point_v<T> T magnitude(T x) {
  return std::abs(x);
}
template <class T, class Abi>
std::experimental::simd<T, Abi> magnitude(std::experimental::simd<T, Abi> const& x) {
  return select(x < 0, -x, x);
}

/// Three numbers as a vector: what a law needs of vector algebra, for any number type.
template <class N> struct Triple {
  N x, y, z;

  friend Triple operator+(Triple const& a, Triple const& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Triple operator-(Triple const& a, Triple const& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Triple operator*(N const& s, Triple const& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class N> N dot(Triple<N> const& a, Triple<N> const& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class N> Triple<N> cross(Triple<N> const& a, Triple<N> const& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Mask, class N>
Triple<N> select(Mask const& condition, Triple<N> const& yes, Triple<N> const& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y),
          select(condition, yes.z, no.z)};
}

} // namespace dem
