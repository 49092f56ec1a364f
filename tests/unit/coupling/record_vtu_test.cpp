#include "coupling/record/vtu.hpp"

#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <map>
#include <regex>

using coupling::PvdSeries;
using coupling::VtuField;
using support::ScratchFolder;

namespace {

/// An independent reader of VTU files with raw appended arrays.
struct ParsedVtu {
  struct Array {
    std::string type;
    int n_components;
    std::string bytes;
  };
  std::string xml;
  std::map<std::string, Array> arrays;

  explicit ParsedVtu(std::string const& file) {
    std::string const mark = "<AppendedData encoding=\"raw\">";
    auto const data = file.find('_', file.find(mark) + mark.size()) + 1;
    xml = file.substr(0, file.find(mark));
    std::regex const entry(
        R"re(<DataArray type="(\w+)" Name="([^"]*)" NumberOfComponents="(\d+)" format="appended" offset="(\d+)"/>)re");
    for (std::sregex_iterator it(xml.begin(), xml.end(), entry), end; it != end; ++it) {
      auto const offset = data + std::stoul((*it)[4]);
      std::uint64_t length = 0;
      std::memcpy(&length, file.data() + offset, sizeof length);
      arrays[(*it)[2]] = {(*it)[1], std::stoi((*it)[3]),
                          file.substr(offset + sizeof length, length)};
    }
    tail = file.substr(file.rfind("</AppendedData>"));
  }

  template <class T> std::vector<T> values(std::string const& name) const {
    auto const& bytes = arrays.at(name).bytes;
    std::vector<T> result(bytes.size() / sizeof(T));
    std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
  }

  std::string tail;
};

} // namespace

TEST(Vtu, GrainsArePointsWithTheirFields) {
  ScratchFolder const folder;
  std::vector<dem::Vec3> const position{{1.0, 2.0, 3.0}, {4.0, 5.0, -0.0}};
  std::vector<double> const diameter{0.5, 1e-300};
  std::vector<float> const overlap{0.25f, 0.1f};
  std::vector<std::uint8_t> const component{0, 1};
  std::vector<std::uint32_t> const id{7, 0xffffffffu};
  std::vector<VtuField> const fields{{"diameter [m]", 1, std::span(diameter)},
                                     {"velocity [m/s]", position},
                                     {"overlap [m]", 1, std::span(overlap)},
                                     {"component", 1, std::span(component)},
                                     {"a < b & \"c\"", 1, std::span(id)}};
  write_points_vtu(folder / "grains.vtu", 0.1, position, fields);

  ParsedVtu const vtu(support::bytes_of(folder / "grains.vtu"));
  EXPECT_NE(vtu.xml.find("byte_order=\"LittleEndian\" header_type=\"UInt64\""), std::string::npos);
  EXPECT_NE(vtu.xml.find("NumberOfPoints=\"2\" NumberOfCells=\"2\""), std::string::npos);
  EXPECT_NE(vtu.xml.find("Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">0.1<"),
            std::string::npos);
  EXPECT_EQ(vtu.tail, "</AppendedData>\n</VTKFile>\n");
  EXPECT_EQ(vtu.values<double>("Points"), (std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0, -0.0}));
  EXPECT_EQ(vtu.values<std::uint32_t>("connectivity"), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(vtu.values<std::uint32_t>("offsets"), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(vtu.values<std::uint8_t>("types"), (std::vector<std::uint8_t>{1, 1})); // VTK_VERTEX
  EXPECT_EQ(vtu.values<double>("diameter [m]"), diameter);
  EXPECT_EQ(vtu.values<double>("velocity [m/s]"),
            (std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0, -0.0}));
  EXPECT_EQ(vtu.arrays.at("velocity [m/s]").n_components, 3);
  EXPECT_EQ(vtu.values<float>("overlap [m]"), overlap);
  EXPECT_EQ(vtu.arrays.at("overlap [m]").type, "Float32");
  EXPECT_EQ(vtu.values<std::uint8_t>("component"), component);
  EXPECT_EQ(vtu.values<std::uint32_t>("a &lt; b &amp; &quot;c&quot;"), id);
}

TEST(Vtu, ToolsAreTrianglesWithTheirPressure) {
  ScratchFolder const folder;
  std::vector<dem::Vec3> const vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  std::vector<std::array<std::uint32_t, 3>> const triangles{{0, 1, 2}, {1, 3, 2}};
  std::vector<double> const pressure{1e6, 2e6};
  std::vector<VtuField> const fields{{"pressure [Pa]", 1, std::span(pressure)}};
  write_triangles_vtu(folder / "tools.vtu", 0.0, vertices, triangles, fields);

  ParsedVtu const vtu(support::bytes_of(folder / "tools.vtu"));
  EXPECT_EQ(vtu.values<std::uint32_t>("connectivity"),
            (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(vtu.values<std::uint32_t>("offsets"), (std::vector<std::uint32_t>{3, 6}));
  EXPECT_EQ(vtu.values<std::uint8_t>("types"), (std::vector<std::uint8_t>{5, 5})); // VTK_TRIANGLE
  EXPECT_EQ(vtu.values<double>("pressure [Pa]"), pressure);
  EXPECT_LT(vtu.xml.find("<CellData>"), vtu.xml.find("pressure [Pa]"));
}

TEST(Vtu, NoGrainsIsAFileToo) {
  ScratchFolder const folder;
  coupling::write_points_vtu(folder / "grains.vtu", 0.0, {}, {});
  ParsedVtu const vtu(support::bytes_of(folder / "grains.vtu"));
  EXPECT_NE(vtu.xml.find("NumberOfPoints=\"0\" NumberOfCells=\"0\""), std::string::npos);
  EXPECT_TRUE(vtu.values<double>("Points").empty());
}

TEST(Pvd, ListsTimesAndGoesOnWhereARestartBegins) {
  ScratchFolder const folder;
  auto const file = folder / "grains.pvd";
  constexpr double forever = std::numeric_limits<double>::infinity();
  {
    PvdSeries series(file, forever);
    series.add(0.0, "grains_0.vtu");
    series.add(0.1 + 0.2, "grains_1.vtu"); // 0.30000000000000004 must read back as itself
    series.add(0.5, "grains_2.vtu");
  }
  PvdSeries resumed(file, 0.1 + 0.2);
  EXPECT_EQ(resumed.size(), 2u);
  resumed.add(0.6, "grains_3.vtu");
  EXPECT_EQ(
      support::bytes_of(file),
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n  <Collection>\n"
      "    <DataSet timestep=\"0\" file=\"grains_0.vtu\"/>\n"
      "    <DataSet timestep=\"0.30000000000000004\" file=\"grains_1.vtu\"/>\n"
      "    <DataSet timestep=\"0.6\" file=\"grains_3.vtu\"/>\n"
      "  </Collection>\n</VTKFile>\n");
  support::put_bytes(file, "<DataSet timestep=\"soon\" file=\"x\"/>\n");
  EXPECT_THROW(PvdSeries(file, forever), dem::InvalidInput);
}
