#include "dem/surface/stl.hpp"

#include "dem/expect.hpp"
#include "dem/surface/tool_shapes.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/solids.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

namespace dem {
namespace {

using support::ScratchFolder;

constexpr double mm = 1e-3;

std::span<std::byte const> bytes_of(std::string const& text) {
  return std::as_bytes(std::span(text));
}

StlTool read(std::string const& content, double scale = mm) {
  return read_stl(bytes_of(content), "die.stl", scale);
}

/// What the reader says of bytes that it must refuse.
std::string refusal(std::string const& content, double scale = mm) {
  try {
    read(content, scale);
  } catch (InvalidInput const& error) {
    return error.what();
  }
  return "accepted";
}

std::string facet(Vec3 const& a, Vec3 const& b, Vec3 const& c) {
  std::ostringstream out;
  out.precision(17);
  out << "facet normal 0 0 0\nouter loop\n";
  for (auto const* v : {&a, &b, &c})
    out << "vertex " << v->transpose() << '\n';
  out << "endloop\nendfacet\n";
  return out.str();
}

std::string ascii(TriangleSurface const& surface) {
  std::string out = "solid test\n";
  for (auto const& [a, b, c] : surface.triangles)
    out += facet(surface.vertices[a], surface.vertices[b], surface.vertices[c]);
  return out + "endsolid test\n";
}

std::string binary(TriangleSurface const& surface, std::string header = "binary") {
  header.resize(80, ' ');
  auto const put = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    header.append(raw, sizeof value);
  };
  put(static_cast<std::uint32_t>(surface.triangles.size()));
  for (auto const& corners : surface.triangles) {
    for (int k = 0; k < 3; ++k)
      put(0.0f);
    for (auto const vertex : corners)
      for (double const x : surface.vertices[vertex])
        put(static_cast<float>(x));
    put(std::uint16_t{0});
  }
  return header;
}

TriangleSurface small_block() {
  return solids::block(2.0, 1.5, 0.5);
} // in mm

TEST(StlRoundTrip, AsciiKeepsEveryBit) {
  ScratchFolder const folder;
  auto const die = make_die(22.05 * mm, 30.0 * mm, 10.0 * mm, 0.01 * mm);
  write_stl(folder / "die.stl", die);
  auto const tool = read_stl(folder / "die.stl");
  ASSERT_EQ(tool.surface.vertices.size(), die.vertices.size()); // welded back
  ASSERT_EQ(tool.surface.triangles.size(), die.triangles.size());
  for (std::size_t t = 0; t < die.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(tool.surface.vertices[tool.surface.triangles[t][k]],
                die.vertices[die.triangles[t][k]]);
  EXPECT_TRUE(tool.report.closed);
  EXPECT_FALSE(std::filesystem::exists(folder / "die.stl.part"));
}

TEST(StlRoundTrip, BinaryKeepsSinglePrecision) {
  ScratchFolder const folder;
  auto const die = make_die(22.05 * mm, 30.0 * mm, 10.0 * mm, 0.01 * mm);
  write_stl(folder / "die.stl", die, StlFormat::binary, mm);
  EXPECT_EQ(std::filesystem::file_size(folder / "die.stl"), 84u + 50u * die.triangles.size());
  auto const tool = read_stl(folder / "die.stl", mm);
  ASSERT_EQ(tool.surface.vertices.size(), die.vertices.size());
  for (std::size_t t = 0; t < die.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      Vec3 const error =
          tool.surface.vertices[tool.surface.triangles[t][k]] - die.vertices[die.triangles[t][k]];
      EXPECT_LT(error.cwiseAbs().maxCoeff(),
                1.2e-9); // half a unit in the last place of 30 mm is 1e-6 mm
    }
  EXPECT_TRUE(tool.report.closed);
}

TEST(StlReader, TellsBinaryBySizeAndNotByTheWordSolid) {
  auto const report = read(binary(small_block(), "solid made by a CAD program")).report;
  EXPECT_EQ(report.n_triangles, 12u);
  EXPECT_EQ(report.n_vertices, 8u);
  EXPECT_NEAR(report.volume, 1.5e-9, 1e-20); // 2 x 1.5 x 0.5 mm^3
  EXPECT_TRUE(report.closed);
  EXPECT_NEAR(report.largest_extent(), 2.0 * mm, 1e-18);
}

TEST(StlReader, TakesOtherPeoplesAscii) {
  auto content = ascii(small_block());
  for (char& c : content)
    c = static_cast<char>(std::toupper(c));
  std::string windows;
  for (char const c : content)
    windows += c == '\n' ? std::string(" \r\n\t") : std::string(1, c);
  EXPECT_EQ(read(windows).report.n_vertices, 8u);
  EXPECT_EQ(
      read("solid\n" + facet({0, 0, 0}, {+1e0, 0, 0}, {0, 1, 0}) + "endsolid").report.n_triangles,
      1u);
  EXPECT_EQ(
      read("solid a b c\nfacet normal nan 0 0 outer loop vertex +1 0 0 vertex 0 1 0 vertex 0 0 1 "
           "endloop endfacet\nendsolid a\n" +
           std::string("solid two\n") + facet({5, 0, 0}, {6, 0, 0}, {5, 1, 0}) + "endsolid two\n")
          .report.n_triangles,
      2u);
}

TEST(StlReader, WeldsWhatAnExporterRoundedApart) {
  // Corners that differ by 1e-8 of the box are one vertex; those that differ by 1e-5 are not.
  auto const nearly = [](double gap) {
    return "solid\n" + facet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}) +
           facet({1, gap, 0}, {1, 1, 0}, {0, 1, gap}) + "endsolid\n";
  };
  EXPECT_EQ(read(nearly(1e-8)).report.n_vertices, 4u);
  EXPECT_EQ(read(nearly(1e-8)).report.n_open_edges, 4u);
  EXPECT_EQ(read(nearly(1e-5)).report.n_vertices, 6u);
}

TEST(StlReader, ReportsOpenEdges) {
  auto lid = small_block();
  lid.triangles.pop_back();
  auto const report = read(ascii(lid)).report;
  EXPECT_FALSE(report.closed);
  EXPECT_EQ(report.n_open_edges, 3u);
  EXPECT_EQ(report.volume, 0.0);
}

TEST(StlRefusal, MissingAndUnreadableFiles) {
  ScratchFolder const folder;
  auto const told = [](std::filesystem::path const& file) -> std::string {
    try {
      read_stl(file);
    } catch (InvalidInput const& error) {
      return error.what();
    }
    return "accepted";
  };
  auto const missing = folder / "no.stl";
  EXPECT_EQ(told(missing),
            missing.string() + ": there is no such file. Is the path relative to the case file?");
  EXPECT_NE(told(folder / "").find("not a file that can be read"), std::string::npos);
  std::ofstream(folder / "empty.stl").close();
  EXPECT_NE(told(folder / "empty.stl").find("empty.stl: the file is empty"), std::string::npos);
}

TEST(StlRefusal, TruncatedAndLyingBinary) {
  auto const whole = binary(small_block());
  EXPECT_EQ(refusal(whole.substr(0, 300)), "die.stl: triangle count = 12 needs 684 bytes, the file "
                                           "has 300 (truncated, or the count is wrong). "
                                           "Export or copy it again?");
  EXPECT_EQ(refusal(whole.substr(0, 60) + std::string(10, '\0')),
            "die.stl: 70 bytes are less than the 84 of a binary STL's header (truncated). Export "
            "or copy it again?");
  auto lying = whole;
  lying[80] = 11;
  EXPECT_EQ(refusal(lying),
            "die.stl: triangle count = 11 needs 634 bytes, the file has 684 (the count is wrong). "
            "Export or copy it again?");
  lying.replace(80, 4, "\xff\xff\xff\xff"); // 4294967295 x 50 + 84: nothing is allocated for it
  EXPECT_EQ(refusal(lying).substr(0, 65),
            "die.stl: triangle count = 4294967295 needs 214748364834 bytes, th");
  // Saying solid does not make truncated binary into text.
  EXPECT_NE(refusal(binary(small_block(), "solid x").substr(0, 300)).find("truncated"),
            std::string::npos);
}

TEST(StlRefusal, TruncatedAndBrokenAscii) {
  auto const whole = ascii(small_block());
  EXPECT_EQ(refusal(whole.substr(0, 60)),
            "die.stl:4: the file ends where 'vertex' should stand (truncated). "
            "Export or copy it again?");
  EXPECT_EQ(
      refusal("solid x\n" + facet({0, 0, 0}, {1, 0, 0}, {0, 1, 0})),
      "die.stl:9: the file ends where 'facet' should stand (truncated). Export or copy it again?");
  EXPECT_EQ(refusal("Hello, this is a letter."),
            "die.stl:1: 'Hello,' where 'solid' should stand (the file is not a valid ASCII STL). "
            "Export it again?");
  EXPECT_EQ(refusal("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 1,5 0"),
            "die.stl:4: vertex = '1,5': not a number. Was the file edited by hand?");
  EXPECT_EQ(refusal("solid x\nendsolid x\n"),
            "die.stl: the file holds no triangles (a tool needs a surface). Is it the right file?");
}

TEST(StlRefusal, CoordinatesThatAreNotFinite) {
  for (std::string const bad : {"nan", "inf", "-infinity"})
    EXPECT_EQ(refusal("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 " + bad),
              "die.stl:4: vertex = '" + bad +
                  "': not a finite number (a tool needs a place). Export the file again?");
  EXPECT_NE(refusal("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 1e999").find("not a number"),
            std::string::npos);
  auto block = small_block();
  block.vertices[block.triangles[3][1]].y() = std::numeric_limits<double>::quiet_NaN();
  auto const told = refusal(binary(block));
  EXPECT_NE(told.find(": a coordinate is not a finite number"), std::string::npos) << told;
  EXPECT_EQ(told.substr(0, 18), "die.stl: triangle ");
}

TEST(StlRefusal, DegenerateTriangles) {
  // The third of three has its corners on a line.
  EXPECT_EQ(refusal("solid\n" + facet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}) +
                    facet({1, 0, 0}, {1, 1, 0}, {0, 1, 0}) +
                    facet({3, 0, 0}, {4, 0, 0}, {5, 0, 0}) + "endsolid\n"),
            "die.stl: triangle 3 is degenerate (its corners lie on one line, so it has no normal). "
            "Remove it?");
  EXPECT_NE(
      refusal("solid\n" + facet({0, 0, 0}, {1, 0, 0}, {1, 0, 0}) + "endsolid\n").find("degenerate"),
      std::string::npos);
}

TEST(StlRefusal, EdgesOfThreeTriangles) {
  EXPECT_EQ(refusal("solid\n" + facet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}) +
                    facet({1, 0, 0}, {0, 0, 0}, {0, 0, 1}) +
                    facet({0, 0, 0}, {1, 0, 0}, {0, -1, 0}) + "endsolid\n"),
            "die.stl: edge (0, 1) belongs to 3 triangles, 1, 2, 3 (a tool surface is a manifold). "
            "Was the file exported twice?");
}

TEST(StlRefusal, NeighboursThatDisagreeAboutTheOutside) {
  auto block = small_block();
  std::swap(block.triangles[4][0], block.triangles[4][1]);
  auto const told = refusal(ascii(block));
  EXPECT_NE(told.find("run the same way along their common edge"), std::string::npos) << told;
  EXPECT_NE(told.find(" 5 "), std::string::npos) << told; // names the turned one, counted from 1
}

TEST(StlRefusal, InsideOutBodies) {
  auto block = small_block();
  for (auto& corners : block.triangles)
    std::swap(corners[0], corners[1]);
  EXPECT_EQ(refusal(ascii(block)), "die.stl: enclosed volume = -1.5e-09 m^3 (corners must run "
                                   "anticlockwise seen from outside, so that the "
                                   "body is inside). Flip the normals?");
  // Two triangles back to back are closed but hold nothing.
  EXPECT_NE(refusal("solid\n" + facet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}) +
                    facet({0, 0, 0}, {0, 1, 0}, {1, 0, 0}) + "endsolid\n")
                .find("enclosed volume = 0"),
            std::string::npos);
}

TEST(StlRefusal, AbsurdScales) {
  // A die of 22.05 mm drawn in millimetres and read as metres is 42 m wide.
  auto die = make_die(22.05, 30.0, 10.0, 0.01);
  EXPECT_EQ(
      refusal(ascii(die), 1.0),
      "die.stl: largest extent = 42.05 m at 'STL scale' = 1: no press tool is larger than 1 m. "
      "Is the file in millimetres (set 'STL scale' = 0.001)?");
  EXPECT_EQ(refusal(ascii(die), mm), "accepted");
  EXPECT_NE(refusal(ascii(die), 1e-9)
                .find("smaller than 10 um. Is the file in metres (set 'STL scale' = 1)"),
            std::string::npos);
  EXPECT_NE(refusal("solid\n" + facet({-1e308, 0, 0}, {1e308, 0, 0}, {0, 1e308, 0}) + "endsolid\n")
                .find("1 m"),
            std::string::npos);
  EXPECT_NE(refusal("solid\n" + facet({1e300, 0, 0}, {1e300, 0, 0}, {1e300, 0, 0}) + "endsolid\n")
                .find("10 um"),
            std::string::npos);
}

TEST(StlWriter, LeavesNothingBehindWhereItCannotWrite) {
  ScratchFolder const folder;
  EXPECT_THROW(write_stl(folder / "no such folder/die.stl", small_block()), InvalidInput);
  EXPECT_FALSE(std::filesystem::exists(folder / "no such folder"));
}

} // namespace
} // namespace dem
