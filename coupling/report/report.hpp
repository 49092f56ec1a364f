#pragma once

#include "coupling/record/press_record.hpp"
#include "coupling/report/script_library.hpp"
#include "dem/vec3.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

/// The report of a run: one HTML file that needs nothing but a browser, no network and no other
/// file.
namespace coupling {

/// A grain as the picture of the compact shows it.
struct PicturedGrain {
  dem::Vec3 position;     ///< [m]
  double radius;          ///< [m]
  std::uint8_t component; ///< row of ReportData::components
  double mean_overlap;    ///< [m], mean over the grain's contacts; 0 when it has none
  double stress;          ///< [Pa], mean of the grain's principal stresses, compression positive
};

/// A tool as the picture outlines it: a cylinder about the press axis.
struct ToolOutline {
  std::string name;
  double radius; ///< [m]
  double bottom; ///< [m], z
  double top;    ///< [m], z; equal to `bottom` for a face
};

/// The surface of a tool with the stress on it, where it stands.
struct PicturedTool {
  std::string name;
  std::vector<dem::Vec3> vertices; ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<double> von_mises; ///< [Pa], of each vertex
};

/// The tools at the largest force, and the grains then.
struct StressPicture {
  std::vector<PicturedGrain> grains;
  std::vector<PicturedTool> tools; ///< empty: there is no such picture
  double time = 0.0;               ///< [s]
};

/// A line "key: value" about where the numbers come from.
struct ProvenanceEntry {
  std::string key;
  std::string value;
};

/// A measured or published number. `max_force` [N] and `compact_height` [m] are also drawn into the
/// charts.
struct ObservedValue {
  std::string name;
  double value;
  std::string unit;
  double sd = std::numeric_limits<double>::quiet_NaN(); ///< standard uncertainty; NaN = not stated
  std::string source;
};

/// Ours beside somebody else's number.
struct ComparedValue {
  std::string quantity;
  std::string unit;
  double ours;
  double theirs;
  std::string source;
};

struct ReportData {
  std::string title;
  Summary summary;
  PressRecord record{{}};
  std::vector<PicturedGrain> grains;
  std::vector<std::string> components;
  std::string
      grains_moment; ///< when the picture was taken, in words: "at the end of stage release"
  std::vector<ToolOutline> tools;
  StressPicture stressed;
  std::vector<ObservedValue> observed;
  std::vector<ComparedValue> comparison;
  std::vector<ProvenanceEntry> provenance;
  std::string resolved_case; ///< text of case.resolved.prm
};

/// Writes the report. The file appears whole or not at all.
/// @param libraries  folder of Debian's JavaScript packages, /usr/share/javascript unless
/// configured otherwise
/// @throws dem::InvalidInput if a library is not installed (names the package) or the file cannot
/// be created;
///         WriteFailed if the disk is full
void write_report(std::filesystem::path const& file, ReportData const& data,
                  std::filesystem::path const& libraries = default_script_libraries());

} // namespace coupling
