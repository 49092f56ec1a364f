#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace continuum {

/// Runs `work` between gmsh's start and end, silent and without its option files. What gmsh reports
/// as an error arrives as InvalidInput that names the file.
/// gmsh is one per process: not to be nested, nor called from two threads.
/// @throws InvalidInput  from `work`, or with gmsh's message
void with_gmsh(std::filesystem::path const& file, std::function<void()> const& work);

} // namespace continuum
