#include "dem/surface/stl.hpp"

#include "dem/expect.hpp"
#include "dem/surface/box_tree.hpp"
#include "dem/surface/stl_facets.hpp"
#include "dem/surface/surface_edges.hpp"
#include "dem/surface/weld.hpp"

#include <Eigen/Geometry>

#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <span>
#include <sstream>
#include <string_view>
#include <system_error>
#include <vector>

namespace dem {

namespace {

constexpr double largest_tool = 1.0;    // [m]
constexpr double smallest_tool = 10e-6; // [m]

std::string text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::vector<StlFacet> parse(std::span<std::byte const> bytes, std::string const& name) {
  VALIDATE(!bytes.empty(), name + ": the file is empty (a tool needs triangles). Export it again?");
  if (is_binary_stl(bytes))
    return parse_binary_stl(bytes, name);
  return parse_ascii_stl({reinterpret_cast<char const*>(bytes.data()), bytes.size()}, name);
}

Box scaled_box(std::vector<StlFacet>& facets, std::string const& name, double scale) {
  VALIDATE(!facets.empty(),
           name + ": the file holds no triangles (a tool needs a surface). Is it the right file?");
  VALIDATE(facets.size() < std::numeric_limits<std::uint32_t>::max() / 3,
           name + ": " + std::to_string(facets.size()) +
               " triangles are too many. Export it coarser?");
  Box box;
  for (auto& facet : facets)
    for (auto& corner : facet) {
      corner *= scale;
      box.include(corner);
    }
  double const extent = (box.high - box.low).maxCoeff();
  std::string const where =
      name + ": largest extent = " + text(extent) + " m at 'STL scale' = " + text(scale);
  VALIDATE(extent <= largest_tool, where + ": no press tool is larger than 1 m. Is the file in "
                                           "millimetres (set 'STL scale' = 0.001)?");
  VALIDATE(extent >= smallest_tool, where + ": no press tool is smaller than 10 um. Is the file in "
                                            "metres (set 'STL scale' = 1), or in "
                                            "millimetres (0.001)?");
  return box;
}

void refuse_inside_out(StlTool const& tool, double diagonal) {
  constexpr double rounding = 1e-12;
  VALIDATE(
      !tool.report.closed || tool.report.volume > rounding * diagonal * diagonal * diagonal,
      tool.surface.name + ": enclosed volume = " + text(tool.report.volume) +
          " m^3 (corners must run anticlockwise seen from outside, so that the body is inside). "
          "Flip the normals?");
}

std::vector<std::byte> read_bytes(std::filesystem::path const& file) {
  std::error_code error;
  auto const kind = std::filesystem::status(file, error).type();
  VALIDATE(kind != std::filesystem::file_type::not_found,
           file.string() + ": there is no such file. Is the path relative to the case file?");
  VALIDATE(kind == std::filesystem::file_type::regular,
           file.string() + ": not a file that can be read. Is it a folder?");
  std::ifstream in(file, std::ios::binary);
  std::string const content{std::istreambuf_iterator<char>(in), {}};
  VALIDATE(in.is_open() && !in.bad(), file.string() + ": cannot be read. Is reading it permitted?");
  auto const bytes = std::as_bytes(std::span(content));
  return {bytes.begin(), bytes.end()};
}

/// Shortest digits that read back as the same number.
void append(std::string& out, Vec3 const& v) {
  for (double const x : v) {
    char digits[32];
    auto const [end, error] = std::to_chars(std::begin(digits), std::end(digits), x);
    out.append(1, ' ').append(digits, end);
  }
}

std::string ascii_stl(TriangleSurface const& surface, double scale) {
  std::string out = "solid " + surface.name + '\n';
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    append(out += "facet normal", area_vector(surface, t).normalized());
    out += "\nouter loop\n";
    for (auto const vertex : surface.triangles[t]) {
      append(out += "vertex", surface.vertices[vertex] / scale);
      out += '\n';
    }
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid " + surface.name + '\n';
}

std::string binary_stl(TriangleSurface const& surface, double scale) {
  std::string out =
      "binary STL of " + surface.name; // must not start with "solid", for simpler readers
  out.resize(80, ' ');
  auto const put = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    out.append(raw, sizeof value);
  };
  put(static_cast<std::uint32_t>(surface.triangles.size()));
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (double const x : area_vector(surface, t).normalized())
      put(static_cast<float>(x));
    for (auto const vertex : surface.triangles[t])
      for (double const x : surface.vertices[vertex])
        put(static_cast<float>(x / scale));
    put(std::uint16_t{0});
  }
  return out;
}

} // namespace

StlTool read_stl(std::span<std::byte const> bytes, std::string const& name, double scale) {
  EXPECT(scale > 0.0);
  auto facets = parse(bytes, name);
  auto const box = scaled_box(facets, name, scale);
  double const diagonal = (box.high - box.low).norm();
  StlTool tool{.surface = weld(name, facets, box, weld_distance * diagonal), .report = {}};
  tool.report = inspect_surface(tool.surface);
  refuse_inside_out(tool, diagonal);
  return tool;
}

StlTool read_stl(std::filesystem::path const& file, double scale) {
  return read_stl(read_bytes(file), file.string(), scale);
}

void write_stl(std::filesystem::path const& file, TriangleSurface const& surface, StlFormat format,
               double scale) {
  auto const content =
      format == StlFormat::ascii ? ascii_stl(surface, scale) : binary_stl(surface, scale);
  auto temporary = file;
  temporary += ".part";
  std::ofstream out(temporary, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  std::error_code error;
  if (out)
    std::filesystem::rename(temporary, file, error);
  if (out && !error)
    return;
  std::filesystem::remove(temporary, error);
  throw InvalidInput(file.string() +
                     ": cannot be written. Does the folder exist, and is the disk full?");
}

} // namespace dem
