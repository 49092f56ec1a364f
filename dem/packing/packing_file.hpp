#pragma once

#include "dem/packing/packing.hpp"

#include <filesystem>
#include <istream>
#include <span>
#include <string>

namespace dem {

/// Reads a packing from CSV: header `x [m],y [m],z [m],diameter [m],component`, optionally also
/// `vx [m/s],vy [m/s],vz [m/s]` and `wx [rad/s],wy [rad/s],wz [rad/s]` (each three together),
/// columns in any order. A component is a name of `components` or its number from 1. Blank lines
/// are passed over.
/// @throws InvalidInput  `file:line: ...` for a file that cannot be read or holds no grain, a
/// column that is missing, doubled or
///         unknown, a wrong number of fields, a number that is none or not finite, a diameter that
///         is not positive, an unknown component
Packing read_packing(std::filesystem::path const& file,
                     std::span<PackingComponent const> components);

/// The same from a stream; `name` stands for the file in messages.
Packing read_packing(std::istream& in, std::string const& name,
                     std::span<PackingComponent const> components);

/// Writes a packing so that read_packing gives back the same bits, velocities and spins included.
/// The file appears whole or not at all.
/// @throws InvalidInput if the file cannot be written
void write_packing(std::filesystem::path const& file, Packing const& packing,
                   std::span<PackingComponent const> components);

} // namespace dem
