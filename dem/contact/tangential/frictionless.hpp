#pragma once

#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_geometry.hpp"
#include "dem/material.hpp"

#include <string_view>

namespace dem {

/// No tangential force.
struct Frictionless {
  static constexpr std::string_view name = "frictionless";
  static constexpr bool has_spring = false;
  static constexpr int n_constants = 0;

  template <class N> struct Constants {};

  static Constants<double> constants(PairMaterial const&, PairSize const&, ContactChoice const&) {
    return {};
  }
};

} // namespace dem
