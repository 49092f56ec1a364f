#pragma once

#include <string>
#include <string_view>

namespace coupling {

/// A text as a message repeats it: on one line, its first 80 bytes.
std::string quote(std::string_view text);

} // namespace coupling
