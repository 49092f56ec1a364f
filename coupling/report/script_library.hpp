#pragma once

#include <filesystem>
#include <string>

namespace coupling {

/// Where Debian installs JavaScript packages, as configured (PRESSCHECK_JAVASCRIPT_DIR).
std::filesystem::path default_script_libraries();

/// three.js and its orbit controls, ready to stand inside a script element.
/// @throws dem::InvalidInput if a file is missing; the message names the Debian package
std::string read_three_js(std::filesystem::path const& libraries);

} // namespace coupling
