#pragma once

#include "coupling/case_file.hpp"
#include "coupling/press_cycle.hpp"
#include "coupling/press_output.hpp"
#include "coupling/press_set_up.hpp"

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

/// The tiny case of tests/regression as a press in memory.
namespace tiny {

inline coupling::Case read(std::vector<std::string> const& changes = {}) {
  return coupling::read_case(PRESSCHECK_SOURCE_DIR "/tests/regression/tiny/case.prm", changes);
}

inline coupling::Press press(std::vector<std::string> const& changes = {}) {
  return coupling::set_up_press(read(changes));
}

/// Runs a press in a folder, to the end or to a stage.
inline coupling::RunEnd run(coupling::Press& press, std::filesystem::path const& folder,
                            std::string const& until = {}) {
  std::ostringstream nowhere;
  coupling::RunFolder files(folder, press.world.time);
  coupling::Progress progress(nowhere, coupling::ProgressStyle::silent);
  return coupling::PressCycle(press, files, progress, [] { return false; }).run(until);
}

} // namespace tiny
