#pragma once

#include <filesystem>
#include <string>

/// Opens pages in Debian's chromium, without a window and without a network.
namespace browser {

struct Page {
  std::string dom;     ///< the document after its scripts ran
  std::string console; ///< what the page said to the console, one line each; empty when all is well

  /// The value of <html data-name="..."> with entities resolved. "(absent)" if there is none.
  std::string note(std::string const& name) const;
  double number(std::string const& name) const;
};

/// @param script  JavaScript to run after the page's own, or empty
/// @throws std::runtime_error if chromium is missing or does not finish
Page open(std::filesystem::path const& file, std::string const& script = "");

} // namespace browser
