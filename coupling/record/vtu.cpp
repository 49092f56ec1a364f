#include "coupling/record/vtu.hpp"

#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <numeric>

namespace coupling {
namespace {

static_assert(std::endian::native == std::endian::little, "the files are declared little-endian");

enum class CellType : std::uint8_t { vertex = 1, triangle = 5 }; // VTK's numbers

std::string escaped(std::string_view text) {
  std::string xml;
  for (char const c : text) {
    switch (c) {
    case '&':
      xml += "&amp;";
      break;
    case '<':
      xml += "&lt;";
      break;
    case '>':
      xml += "&gt;";
      break;
    case '"':
      xml += "&quot;";
      break;
    default:
      xml += c;
    }
  }
  return xml;
}

constexpr char const* vtk_type(double) {
  return "Float64";
}
constexpr char const* vtk_type(float) {
  return "Float32";
}
constexpr char const* vtk_type(std::uint8_t) {
  return "UInt8";
}
constexpr char const* vtk_type(std::uint32_t) {
  return "UInt32";
}

/// Collects the XML text and the raw blocks that it points to.
class Vtu {
public:
  void text(std::string_view line) { xml_ += line; }

  void array(VtuField const& field) {
    std::visit(
        [&](auto values) {
          auto const bytes = std::as_bytes(values);
          xml_ += fmt::format("        <DataArray type=\"{}\" Name=\"{}\" "
                              "NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
                              vtk_type(typename decltype(values)::value_type{}),
                              escaped(field.name), field.n_components, offset_);
          blocks_.push_back(bytes);
          offset_ += sizeof(std::uint64_t) + bytes.size();
        },
        field.values);
  }

  void write(std::filesystem::path const& name) const {
    AtomicFile file(name);
    file.write(xml_);
    file.write("  <AppendedData encoding=\"raw\">\n    _");
    for (auto const block : blocks_) {
      std::uint64_t const length = block.size();
      file.write(std::as_bytes(std::span(&length, 1)));
      file.write(block);
    }
    file.write("\n  </AppendedData>\n</VTKFile>\n");
    file.commit();
  }

private:
  std::string xml_;
  std::vector<std::span<std::byte const>> blocks_;
  std::uint64_t offset_ = 0; // [bytes], of the next block behind the underscore
};

struct Cells {
  CellType type;
  std::size_t size; ///< number of cells
  std::span<std::uint32_t const> connectivity;
};

void expect_sizes([[maybe_unused]] std::span<VtuField const> fields,
                  [[maybe_unused]] std::size_t n_items) {
#ifdef PRESSCHECK_CONTRACTS
  for (auto const& field : fields)
    EXPECT(std::visit([](auto v) { return v.size(); }, field.values) ==
           n_items * static_cast<std::size_t>(field.n_components));
#endif
}

void write_vtu(std::filesystem::path const& file, double time, std::span<dem::Vec3 const> points,
               Cells const& cells, std::span<VtuField const> point_fields,
               std::span<VtuField const> cell_fields) {
  expect_sizes(point_fields, points.size());
  expect_sizes(cell_fields, cells.size);
  auto const corners =
      cells.size == 0 ? 0u : static_cast<std::uint32_t>(cells.connectivity.size() / cells.size);
  std::vector<std::uint32_t> offsets(cells.size);
  for (std::size_t i = 0; i < offsets.size(); ++i)
    offsets[i] = corners * static_cast<std::uint32_t>(i + 1);
  std::vector<std::uint8_t> const types(cells.size, static_cast<std::uint8_t>(cells.type));

  Vtu vtu;
  vtu.text("<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n"
           "  <UnstructuredGrid>\n    <FieldData>\n");
  vtu.text(fmt::format("      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                       "format=\"ascii\">{}"
                       "</DataArray>\n    </FieldData>\n",
                       shortest(time)));
  vtu.text(fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n      <Points>\n",
                       points.size(), cells.size));
  vtu.array({"Points", points});
  vtu.text("      </Points>\n      <Cells>\n");
  vtu.array({"connectivity", 1, cells.connectivity});
  vtu.array({"offsets", 1, std::span<std::uint32_t const>(offsets)});
  vtu.array({"types", 1, std::span<std::uint8_t const>(types)});
  vtu.text("      </Cells>\n      <PointData>\n");
  for (auto const& field : point_fields)
    vtu.array(field);
  vtu.text("      </PointData>\n      <CellData>\n");
  for (auto const& field : cell_fields)
    vtu.array(field);
  vtu.text("      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n");
  vtu.write(file);
}

} // namespace

void write_points_vtu(std::filesystem::path const& file, double time,
                      std::span<dem::Vec3 const> points, std::span<VtuField const> point_fields) {
  std::vector<std::uint32_t> each(points.size());
  std::iota(each.begin(), each.end(), 0u);
  write_vtu(file, time, points, {CellType::vertex, points.size(), each}, point_fields, {});
}

void write_triangles_vtu(std::filesystem::path const& file, double time,
                         std::span<dem::Vec3 const> vertices,
                         std::span<std::array<std::uint32_t, 3> const> triangles,
                         std::span<VtuField const> triangle_fields) {
  std::span<std::uint32_t const> const corners(triangles.empty() ? nullptr : triangles[0].data(),
                                               3 * triangles.size());
  write_vtu(file, time, vertices, {CellType::triangle, triangles.size(), corners}, {},
            triangle_fields);
}

} // namespace coupling
