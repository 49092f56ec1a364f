#pragma once

#include "coupling/record/press_record.hpp"
#include "dem/spheres.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coupling {

/// Where a result comes from. No host, path or date: two files may be compared.
struct Provenance {
  std::string version;   ///< of the program
  std::string case_text; ///< the full case as understood, .prm
  std::uint64_t seed = 0;
  int threads = 1;
};

/// Writes `grains_<index>.h5`: time, stage and the grains in the order of their ids. One file a
/// snapshot keeps the memory of a run independent of their number; run.h5 links to them.
/// @throws dem::InvalidInput, WriteFailed
void write_grain_frame(std::filesystem::path const& file, double time, std::string const& stage,
                       dem::Spheres const& grains);

/// Reads the grains of a frame, a run.h5 (its last state) or a restart file.
/// @throws dem::InvalidInput
dem::Spheres read_grains(std::filesystem::path const& file);

/// Writes run.h5:
///   curves/<column>   one dataset a column, attribute `unit`;  curves/stage
///   summary/<value>   the numbers of summary.json, attribute `unit`;  summary/checks/...
///   grains/...        the last state, in the order of the ids
///   snapshots/<name>  links to the frames, each with time, stage and grains/...
///   provenance/...    version, case_text, seed, threads
/// @param frames  names of the frames' files, in the folder of `file`
/// @throws dem::InvalidInput, WriteFailed
void write_run_file(std::filesystem::path const& file, PressRecord const& record,
                    Summary const& summary, Provenance const& provenance, dem::Spheres const& last,
                    std::vector<std::string> const& frames);

} // namespace coupling
