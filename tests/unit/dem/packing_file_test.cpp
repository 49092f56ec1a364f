#include "dem/packing/packing_file.hpp"

#include "dem/expect.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace dem {
namespace {

std::vector<PackingComponent> const components{{"MgO", 3500.0, 0}, {"Al2O3", 3000.0, 1}};
std::string const plain_header = "x [m],y [m],z [m],diameter [m],component\n";

Packing read_text(std::string const& text) {
  std::istringstream in(text);
  return read_packing(in, "bed.csv", components);
}

std::string message_for(std::string const& text) {
  try {
    read_text(text);
  } catch (InvalidInput const& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PackingFile, ReadsComponentsByNameAndByNumber) {
  Packing const grains =
      read_text(plain_header + "1e-3,-2e-3,+0.5e-3,5e-4,Al2O3\n0,0,2e-3,1e-3,1\n");
  ASSERT_EQ(grains.size(), 2u);
  EXPECT_EQ(grains[0].position, Vec3(1e-3, -2e-3, 0.5e-3));
  EXPECT_EQ(grains[0].diameter, 5e-4);
  EXPECT_EQ(grains[0].component, 1);
  EXPECT_EQ(grains[0].velocity, Vec3::Zero().eval());
  EXPECT_EQ(grains[1].component, 0);
}

TEST(PackingFile, TakesColumnsInAnyOrderAndLineEndsOfAnySystem) {
  Packing const grains =
      read_text("\xef\xbb\xbf"
                "component, diameter [m] ,z [m],wx [rad/s],y [m],wz [rad/s],x [m],wy [rad/s]\r\n"
                "2,4e-4,3,40,2,60,1,50\r\n\r\n");
  ASSERT_EQ(grains.size(), 1u);
  EXPECT_EQ(grains[0].position, Vec3(1, 2, 3));
  EXPECT_EQ(grains[0].spin, Vec3(40, 50, 60));
  EXPECT_EQ(grains[0].diameter, 4e-4);
  EXPECT_EQ(grains[0].component, 1);
}

TEST(PackingFile, NamesFileLineAndEntryOfEachDefect) {
  struct Defect {
    std::string text, message;
  };
  std::string const good = "0,0,1e-3,5e-4,1\n";
  std::vector<Defect> const defects{
      {"", "bed.csv:1: the file is empty"},
      {"\n \n", "bed.csv:1: the file is empty"},
      {plain_header, "bed.csv:1: there are no grains"},
      {"x [m],y [m],z [m],component\n", "bed.csv:1: column 'diameter [m]' is missing"},
      {good, "bed.csv:1: unknown column '0'"},
      {"x [m],y [m],z [m],diameter [mm],component\n", "bed.csv:1: unknown column 'diameter [mm]'"},
      {"x [m],y [m],z [m],diameter [m],component,x [m]\n",
       "bed.csv:1: column 'x [m]' occurs twice"},
      {"x [m],y [m],z [m],diameter [m],component,vx [m/s]\n",
       "bed.csv:1: column 'vy [m/s]' is missing"},
      {"x [m],y [m],z [m],diameter [m],component,wz [rad/s]\n",
       "bed.csv:1: column 'wx [rad/s]' is missing"},
      {plain_header + good + "0,0,1e-3,5e-4\n", "bed.csv:3: 4 fields (the header has 5)"},
      {plain_header + good + "0,0,1e-3,5e-4,1,\n", "bed.csv:3: 6 fields (the header has 5)"},
      {plain_header + "0,nan,1e-3,5e-4,1\n", "bed.csv:2: y [m] = 'nan' is not finite"},
      {plain_header + "0,0,inf,5e-4,1\n", "bed.csv:2: z [m] = 'inf' is not finite"},
      {plain_header + "0,0,1e-3mm,5e-4,1\n", "bed.csv:2: z [m] = '1e-3mm' is not a number"},
      {plain_header + "0,,1e-3,5e-4,1\n", "bed.csv:2: y [m] = '' is not a number"},
      {plain_header + "1e999,0,1e-3,5e-4,1\n", "bed.csv:2: x [m] = '1e999' is not a number"},
      {plain_header + good + "\n0,0,1e-3,-5e-4,1\n",
       "bed.csv:4: diameter [m] = -5e-4 (a grain has a positive one)"},
      {plain_header + "0,0,1e-3,0,1\n", "bed.csv:2: diameter [m] = 0 ("},
      {plain_header + "0,0,1e-3,5e-4,SiC\n",
       "bed.csv:2: component = 'SiC' is not in the powder (known: MgO, Al2O3"},
      {plain_header + "0,0,1e-3,5e-4,0\n", "bed.csv:2: component = '0' is not"},
      {plain_header + "0,0,1e-3,5e-4,3\n", "bed.csv:2: component = '3' is not"},
      {plain_header + "0,0,1e-3,5e-4,1.5\n", "bed.csv:2: component = '1.5' is not"},
  };
  for (Defect const& defect : defects) {
    std::string const message = message_for(defect.text);
    EXPECT_TRUE(message.starts_with(defect.message)) << message << "\ninstead of\n"
                                                     << defect.message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(PackingFile, GivesBackEveryBitOfAWrittenPacking) {
  auto const file = std::filesystem::temp_directory_path() / "presscheck_packing_file_test.csv";
  Packing const grains{
      {Vec3(0.1, -1.0 / 3.0, 5e-324), 0.1 + 0.2, 1, Vec3(1e-17, -0.2, 1e300), Vec3(2, 3, -4)},
      {Vec3(-0.0, 1e-3, 2e-3), 1e-4, 0}};
  write_packing(file, grains, components);
  Packing const read = read_packing(file, components);
  ASSERT_EQ(read.size(), grains.size());
  for (std::size_t i = 0; i < grains.size(); ++i) {
    EXPECT_EQ(read[i].position, grains[i].position);
    EXPECT_EQ(read[i].diameter, grains[i].diameter);
    EXPECT_EQ(read[i].component, grains[i].component);
    EXPECT_EQ(read[i].velocity, grains[i].velocity);
    EXPECT_EQ(read[i].spin, grains[i].spin);
  }
  std::filesystem::remove(file);
}

TEST(PackingFile, RefusesPathsItCannotUseAndLeavesNothingBehind) {
  auto const folder = std::filesystem::temp_directory_path() / "presscheck_no_such_folder";
  EXPECT_THROW(read_packing(folder / "bed.csv", components), InvalidInput);
  EXPECT_THROW(read_packing(std::filesystem::temp_directory_path(), components), InvalidInput);
  EXPECT_THROW(write_packing(folder / "bed.csv", {}, components), InvalidInput);
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(Packing, SurvivesTheWayThroughSpheres) {
  Packing const grains{{Vec3(1, 2, 3), 0.3, 1, Vec3(4, 5, 6), Vec3(7, 8, 9)},
                       {Vec3(0, 0, 1), 0.1, 0}};
  std::vector<PackingComponent> const swapped{{"MgO", 3500.0, 5}, {"Al2O3", 3000.0, 2}};
  Spheres const spheres = make_spheres(grains, swapped);
  EXPECT_DOUBLE_EQ(spheres.mass[0], 3000.0 * sphere_volume(0.15));
  EXPECT_EQ(spheres.material[0], 2);
  Packing const back = make_packing(spheres, swapped);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    EXPECT_EQ(back[i].position, grains[i].position);
    EXPECT_EQ(back[i].diameter, grains[i].diameter);
    EXPECT_EQ(back[i].component, grains[i].component);
    EXPECT_EQ(back[i].spin, grains[i].spin);
  }
  EXPECT_THROW(make_packing(spheres, components), InvalidInput); // material 5 is unknown
}

} // namespace
} // namespace dem
