#pragma once

#include "coupling/measured/measured_data.hpp"
#include "coupling/measured/placed_json.hpp"
#include "coupling/quantity.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// Values out of a JSON file; all throw dem::InvalidInput with the place.
namespace coupling::measured {

/// Refuses what is no object, and members that are not `known`, with the nearest name that is.
void check_members(PlacedJson const& object, std::span<std::string const> known);

/// @param why  what the member is for, for the message where it is missing
PlacedJson const& needed(PlacedJson const& object, std::string const& name, std::string_view why);

std::string text_of(PlacedJson const& node);

/// The place in `choices` of what is written.
std::size_t choice_of(PlacedJson const& node, std::span<std::string const> choices);

/// A number in `unit`, or a text with its own (`"1 mm/min"`).
/// @param unit  empty: SI
double quantity_of(PlacedJson const& node, Physical physical, std::string const& unit = "");

/// quantity_of, refused unless it is > 0.
double positive_of(PlacedJson const& node, Physical physical, std::string const& unit = "");

/// The member `unit`, which may be missing where all of `numbers` are texts with units.
std::string unit_of(PlacedJson const& object, std::span<std::string const> numbers);

/// `{"value": 9.13, "sd": 0.01, "unit": "g"}`
Uncertain uncertain_of(PlacedJson const& object, Physical physical);

} // namespace coupling::measured
