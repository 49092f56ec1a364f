#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace crosscode {

/// @throws std::runtime_error if the file cannot be written
inline void write_text(std::filesystem::path const& file, std::string const& text) {
  std::ofstream out(file);
  out << text;
  if (!out.flush())
    throw std::runtime_error(file.string() + ": cannot be written. Is the disk full?");
}

/// Everything in the file; empty if there is none.
inline std::string read_text(std::filesystem::path const& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

} // namespace crosscode
