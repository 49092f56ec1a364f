#pragma once

#include <span>
#include <string>
#include <string_view>

namespace coupling {

/// Number of single-character insertions, deletions and replacements between two texts, letters
/// compared without case. Source: Wagner and Fischer, J. ACM 21 (1974) 168.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name nearest to `written`, or empty if none is near enough to be a typing mistake: a third
/// of its letters, two in a short name, one in up to three letters.
std::string nearest_name(std::string_view written, std::span<std::string const> names);

/// ` Did you mean 'name'?`, or ` ` and the other question where no name is near.
std::string did_you_mean(std::string_view written, std::span<std::string const> names,
                         std::string_view otherwise);

} // namespace coupling
