#pragma once

#include "coupling/case.hpp"
#include "coupling/case_text.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace coupling {

/// Reads a .prm or .json case, applies `overrides` ("Section/Entry=value"), validates every entry.
/// @throws dem::InvalidInput  `file:line: Section/Entry = value: problem (why). Way out?`
Case read_case(std::filesystem::path const& file, std::span<std::string const> overrides = {});

/// The same with values that stand in another file, which messages then name.
Case read_case_with(std::filesystem::path const& file, std::span<PlacedValue const> values);

/// The same from text, for resuming a run from the case kept in its folder. `name` stands for the
/// file in messages.
Case parse_case(std::string const& prm_text, std::filesystem::path const& name,
                std::span<std::string const> overrides = {});

enum class DefaultsFormat { prm, json };

/// Every entry with default, unit, allowed range and description.
std::string describe_entries(DefaultsFormat format);

} // namespace coupling
