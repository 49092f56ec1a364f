#pragma once

#include "coupling/case.hpp"
#include "coupling/case_schema.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// From the text of an entry to its value. All throw dem::InvalidInput `problem (why). Way out?`
/// without a place.
namespace coupling {

/// A number of an entry of kind quantity, inside its range [SI].
double parse_number(Entry const& entry, std::string_view text);

/// A whole number inside the entry's range.
std::uint64_t parse_count(Entry const& entry, std::string_view text);

/// true, yes, on; false, no, off.
bool parse_truth(std::string_view text);

/// One of the entry's choices.
std::string parse_choice(Entry const& entry, std::string_view text);

/// `0.5 mm: 35 %, 1 mm: 65 %`; whether the shares make 100 % is left to the caller.
std::vector<SizeClass> parse_size_classes(Entry const& entry, std::string_view text);

/// `die, upper_punch`; empty for none.
std::vector<std::string> parse_tools(std::string_view text);

/// Whether a text fits its entry, for every kind.
void check_value(Entry const& entry, std::string_view text);

/// The texts that the functions above read as the same value.
std::string print_truth(bool value);
std::string print_size_classes(std::vector<SizeClass> const& sizes);
std::string print_list(std::vector<std::string> const& names);

} // namespace coupling
