#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

/// The text block at the head of our HDF5 files, by which a reader knows that they are ours, whole
/// and undamaged.
namespace coupling {

inline constexpr std::size_t seal_size = 512; ///< [bytes], the smallest user block that HDF5 allows

/// The block for a file whose bytes behind it are `body`.
std::string make_seal(std::span<std::byte const> body);

/// Reads the file once and compares it with its seal.
/// @throws dem::InvalidInput if it is missing, foreign, truncated, longer than sealed, or damaged
void verify_seal(std::filesystem::path const& name);

} // namespace coupling
