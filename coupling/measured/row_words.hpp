#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace coupling::measured {

/// `row 7`, `rows 4, 7 to 9 and 20`; after twelve parts ` and 31 more`.
/// @param rows  at least one, increasing
std::string rows_in_words(std::span<std::size_t const> rows);

} // namespace coupling::measured
