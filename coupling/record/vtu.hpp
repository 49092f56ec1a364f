#pragma once

#include "dem/vec3.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// Files for ParaView: VTK XML, little-endian, arrays appended as raw bytes behind 64-bit lengths.
/// Source: Kitware, VTK File Formats (XML, unstructured grid, raw appended data).
namespace coupling {

/// A named array, one item of `n_components` numbers per point or cell; Vec3 counts as three. The
/// numbers are not copied and must live until the file is written.
struct VtuField {
  using Values = std::variant<std::span<double const>, std::span<float const>,
                              std::span<std::uint8_t const>, std::span<std::uint32_t const>>;
  std::string name; ///< with the unit: "velocity [m/s]"
  int n_components;
  Values values;

  VtuField(std::string field_name, int components, Values numbers)
      : name(std::move(field_name)), n_components(components), values(numbers) {}
  VtuField(std::string field_name, std::span<dem::Vec3 const> vectors)
      : VtuField(std::move(field_name), 3,
                 std::span<double const>(vectors.empty() ? nullptr : vectors[0].data(),
                                         3 * vectors.size())) {}
};

/// Points (grains), each a cell of its own.
/// @param time  [s], shown by ParaView
/// @throws dem::InvalidInput, WriteFailed
void write_points_vtu(std::filesystem::path const& file, double time,
                      std::span<dem::Vec3 const> points, std::span<VtuField const> point_fields);

/// Triangles (tools), with one value per triangle in each field.
void write_triangles_vtu(std::filesystem::path const& file, double time,
                         std::span<dem::Vec3 const> vertices,
                         std::span<std::array<std::uint32_t, 3> const> triangles,
                         std::span<VtuField const> triangle_fields);

/// A .pvd file: which .vtu belongs to which time. Rewritten as a whole with each entry, so ParaView
/// can follow a run.
class PvdSeries {
public:
  /// @param file  if it is there already, its entries up to `time` [s] are kept: pass the time a
  /// resumed run starts from
  /// @throws dem::InvalidInput if an existing file cannot be read
  PvdSeries(std::filesystem::path file, double time);

  /// @param vtu   name relative to the folder of the .pvd
  /// @throws dem::InvalidInput, WriteFailed
  void add(double time, std::string const& vtu);

  std::size_t size() const { return entries_.size(); }

private:
  struct Entry {
    double time;
    std::string vtu;
  };

  std::filesystem::path file_;
  std::vector<Entry> entries_;
};

} // namespace coupling
