#pragma once

#include <map>
#include <string>

namespace coupling {

/// A .prm file that sets the given entries, in the order of the schema. @param values  path -> text
std::string print_prm(std::map<std::string, std::string> const& values);

/// The list of all entries as a .prm case with comments. Entries that the default case does not use
/// are commented out, so that the text is itself the default case. @param used  entries of the
/// default case, path -> text
std::string print_annotated_prm(std::map<std::string, std::string> const& used);

/// The same as a .json case whose entries are objects with value, unit, range and description;
/// entries that the default case does not use have a default but no value.
std::string print_annotated_json(std::map<std::string, std::string> const& used);

} // namespace coupling
