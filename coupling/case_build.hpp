#pragma once

#include "coupling/case_reader.hpp"

namespace coupling {

/// The parts of a Case from its text, each value inside its own range. What the values mean to each
/// other is checked by case_checks. @throws dem::InvalidInput
std::string read_mode(CaseReader& read);
Powder read_powder(CaseReader& read);
/// Fines and the state of the fill, once the components are known.
void read_fill(CaseReader& read, Powder& powder);
Contacts read_contacts(CaseReader& read);
BreakageLaw read_breakage(CaseReader& read);
Tooling read_tooling(CaseReader& read);
/// Fills shapes and ring.
void read_tool_shapes(CaseReader& read, ElasticTools& tools, Tooling const& tooling);
std::vector<Stage> read_stages(CaseReader& read);

/// The whole case, checked, with its resolved text.
/// @param file  where it was read from
Case build_case(CaseText const& text, std::filesystem::path const& file);

} // namespace coupling
