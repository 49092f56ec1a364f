#pragma once

namespace continuum {

/// What all ranks but the first do: takes part in what the first rank's tools ask for, until its
/// session ends.
void help_with_tools();

} // namespace continuum
