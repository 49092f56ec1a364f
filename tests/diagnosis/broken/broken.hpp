#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

/// Diagnosers that are wrong in a known way. Each must fail a bar of the judge: else nobody knows
/// whether the bars can fail.
namespace broken {

/// Those that look at the data at most for its peak.
///   consistent   nothing is ever wrong          frequent   always frame compliance
///   undecided    always the whole library       unknown    always something else
///   peak         names E by the largest force alone
/// Those that spoil a good answer.
///   permuted     names handed on to the next    reversed   sizes of the other sign
///   narrow       intervals ten times too short  deaf       only every fourth alarm is heard
///   greedy       a second name beside each
std::vector<std::string_view> const& names();
bool needs_answer(std::string_view name);

/// @param data    folder with measured.json
/// @param answer  a good diagnosis.json, for those that need one
/// @throws std::invalid_argument for a name that is none
nlohmann::ordered_json diagnose(std::string_view name, std::filesystem::path const& data,
                                std::filesystem::path const& answer);

} // namespace broken
