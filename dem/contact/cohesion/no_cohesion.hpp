#pragma once

#include "dem/contact/contact_geometry.hpp"
#include "dem/material.hpp"

#include <string_view>

namespace dem {

/// No cohesion.
struct NoCohesion {
  static constexpr int n_constants = 0;
  static bool knows(std::string_view name) { return name == "none"; }

  template <class N> struct Constants {};

  static Constants<double> constants(PairMaterial const&, PairSize const&, std::string_view) {
    return {};
  }

  template <class N> static N force(Constants<N> const&, ContactGeometry<N> const&) { return N(0); }
  static double energy(Constants<double> const&, double, double, double) { return 0.0; }
};

} // namespace dem
