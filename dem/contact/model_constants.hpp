#pragma once

#include "dem/contact/contact_model.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>
#include <utility>

/// The constants of a contact model as a row of numbers, law after law: written once for each
/// contact, read in packs.
namespace dem::sweep_detail {

/// Constants of a law, `stride` numbers apart.
template <class C, class N, class T, std::size_t... S>
C load_constants(T const* at, std::size_t stride, std::index_sequence<S...>) {
  [[maybe_unused]] auto const load = [&](std::size_t s) {
    if constexpr (std::is_same_v<N, T>)
      return at[s * stride];
    else
      return N(at + s * stride, std::experimental::element_aligned);
  };
  return C{load(S)...};
}

template <class Model, class N, class T>
typename Model::template Constants<N> load_model_constants(T const* at, std::size_t stride) {
  using C = typename Model::template Constants<N>;
  constexpr std::size_t n = Model::NormalLaw::n_constants, c = Model::CohesionLaw::n_constants,
                        t = Model::TangentialLaw::n_constants, r = Model::RollingLaw::n_constants;
  return C{load_constants<decltype(C::normal), N>(at, stride, std::make_index_sequence<n>{}),
           load_constants<decltype(C::cohesion), N>(at + n * stride, stride,
                                                    std::make_index_sequence<c>{}),
           load_constants<decltype(C::tangential), N>(at + (n + c) * stride, stride,
                                                      std::make_index_sequence<t>{}),
           load_constants<decltype(C::rolling), N>(at + (n + c + t) * stride, stride,
                                                   std::make_index_sequence<r>{})};
}

template <class Model> typename Model::template Constants<double> from_row(double const* row) {
  return load_model_constants<Model, double>(row, 1);
}

template <class Model>
void write_constants(PairMaterial const& pair, PairSize const& size, ContactChoice const& choice,
                     double* out) {
  auto const c = Model::constants(pair, size, choice);
  auto const put = [&out]<class C>(C const& part, auto n) {
    if constexpr (decltype(n)::value > 0) {
      auto const numbers = std::bit_cast<std::array<double, decltype(n)::value>>(part);
      out = std::copy(numbers.begin(), numbers.end(), out);
    }
  };
  put(c.normal, std::integral_constant<std::size_t, Model::NormalLaw::n_constants>{});
  put(c.cohesion, std::integral_constant<std::size_t, Model::CohesionLaw::n_constants>{});
  put(c.tangential, std::integral_constant<std::size_t, Model::TangentialLaw::n_constants>{});
  put(c.rolling, std::integral_constant<std::size_t, Model::RollingLaw::n_constants>{});
}

} // namespace dem::sweep_detail
