#pragma once

#include <cstddef>

/// Four numbers side by side, and the 4 x 4 transpose between one record a contact and one array a
/// component: what the sweep's gather and scatter stages are made of.
namespace dem {

template <class T> struct LanesOf {
  typedef T type __attribute__((vector_size(4 * sizeof(T)), aligned(4 * sizeof(T)), may_alias));
};
template <class T> using Lanes = typename LanesOf<T>::type;

template <class T> Lanes<T> load_lanes(T const* p) {
  return *reinterpret_cast<Lanes<T> const*>(p);
}
template <class T> void store_lanes(T* p, Lanes<T> v) {
  *reinterpret_cast<Lanes<T>*>(p) = v;
}

/// Rows become columns.
template <class V> void transpose(V& a, V& b, V& c, V& d) {
  V const ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  V const ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  V const cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  V const cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

} // namespace dem
