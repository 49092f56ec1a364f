#pragma once

#include "coupling/quantity.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coupling::measured {

/// A quantity that measured data may hold.
struct QuantityKind {
  std::string_view name;
  Physical physical;
};

/// Channels of a run beside its time.
std::span<QuantityKind const> channel_kinds();

/// Single numbers of a run.
std::span<QuantityKind const> scalar_kinds();

/// @return  nullptr if there is none of that name
QuantityKind const* find_kind(std::span<QuantityKind const> kinds, std::string_view name);

std::vector<std::string> names_of(std::span<QuantityKind const> kinds);

} // namespace coupling::measured
