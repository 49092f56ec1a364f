#pragma once

#include "tests/diagnosis/hide/cases.hpp"

#include <filesystem>

namespace hidden {

enum class Lambda { leave_out, compute };

/// Writes FOLDER/data (measured.json and a file a run: what a laboratory hands over) and
/// FOLDER/sealed/truth.json (what only the judge reads).
/// @throws std::runtime_error where a file cannot be written, or the folder is not empty
void write_case(Case const& hidden_case, std::filesystem::path const& folder, Lambda lambda);

} // namespace hidden
