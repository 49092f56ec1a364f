#pragma once

#include "tests/diagnosis/hide/cases.hpp"

#include <filesystem>

namespace hidden {

/// What the generator foretells: nothing, lambda, or also Delta to each rival (three seconds).
enum class Foretold { nothing, lambda, separation };

/// Writes FOLDER/data (measured.json and a file a run: what a laboratory hands over) and
/// FOLDER/sealed/truth.json (what only the judge reads).
/// @throws std::runtime_error where a file cannot be written, or the folder is not empty
void write_case(Case const& hidden_case, std::filesystem::path const& folder, Foretold foretold);

} // namespace hidden
