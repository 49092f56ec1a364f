#include "coupling/quote.hpp"

#include <algorithm>

namespace coupling {

std::string quote(std::string_view text) {
  constexpr std::size_t longest = 80; // bytes
  std::size_t cut = std::min(text.size(), longest);
  // Not inside a UTF-8 character.
  while (cut < text.size() && cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xc0u) == 0x80u)
    --cut;
  std::string quoted(text.substr(0, cut));
  std::ranges::replace_if(
      quoted, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  if (cut < text.size())
    quoted += "...";
  return quoted;
}

} // namespace coupling
