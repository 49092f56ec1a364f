#include "coupling/record/atomic_file.hpp"
#include "coupling/record/h5.hpp"

#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/small_disk.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <bit>
#include <cmath>
#include <limits>

using coupling::H5Reader;
using coupling::H5Writer;
using support::ScratchFolder;

namespace {

std::string message_of(auto&& action) {
  try {
    action();
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return {};
}

void write_sample(std::filesystem::path const& file) {
  H5Writer writer(file);
  writer.write("grains/radius", std::vector<double>{1.0, 2.0, 3.0});
  writer.write("step", std::uint64_t{7});
  writer.commit();
}

/// Every kind of double whose bits a careless reader would change.
std::vector<double> awkward_doubles() {
  using Limits = std::numeric_limits<double>;
  return {0.0,
          -0.0,
          Limits::denorm_min(),
          -Limits::denorm_min(),
          Limits::max(),
          Limits::min(),
          Limits::infinity(),
          -Limits::infinity(),
          0.1,
          1.0 / 3.0,
          std::bit_cast<double>(0x7ff8000000000123u)}; // a NaN with a payload
}

template <class T> std::vector<std::uint64_t> bits(std::vector<T> const& values) {
  using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  std::vector<std::uint64_t> result;
  for (T const value : values)
    result.push_back(std::bit_cast<Bits>(value));
  return result;
}

} // namespace

TEST(H5File, GivesBackEveryTypeToTheBit) {
  ScratchFolder const folder;
  auto const doubles = awkward_doubles();
  std::vector<float> const floats{-0.0f, std::numeric_limits<float>::denorm_min(), 0.1f,
                                  std::bit_cast<float>(0x7fc00123u)};
  std::vector<dem::Vec3> const vectors{{1.0, -0.0, 5e-324}, {4.0, 5.0, 6.0}};
  std::vector<std::uint8_t> const small{0, 255};
  std::vector<std::uint32_t> const medium{0, 0xffffffffu};
  std::vector<std::uint64_t> const large{0, ~std::uint64_t{0}, (std::uint64_t{1} << 53) + 1};
  std::vector<std::int32_t> const negative{-1, std::numeric_limits<std::int32_t>::min()};
  std::vector<std::string> const texts{"", "loading", "Ärmel"};
  {
    H5Writer writer(folder / "a.h5");
    writer.write("doubles", doubles);
    writer.write("a/b/floats", floats);
    writer.write("vectors", vectors);
    writer.write("small", small);
    writer.write("medium", medium);
    writer.write("large", large);
    writer.write("negative", negative);
    writer.write("texts", texts);
    writer.write("text", std::string("subsection Press\n  set Speed = 1 m/s\nend\n"));
    writer.write("no_text", std::string());
    writer.write("nothing", std::vector<dem::Vec3>{});
    writer.write("minus_zero", -0.0);
    writer.write("count", ~std::uint64_t{0});
    writer.write("flag", true);
    writer.write("axis", dem::Vec3(0.0, -0.0, 1.0));
    writer.commit();
  }
  H5Reader const reader(folder / "a.h5");
  EXPECT_EQ(bits(reader.get<std::vector<double>>("doubles")), bits(doubles));
  EXPECT_EQ(bits(reader.get<std::vector<float>>("a/b/floats")), bits(floats));
  auto const read_vectors = reader.get<std::vector<dem::Vec3>>("vectors");
  ASSERT_EQ(read_vectors.size(), 2u);
  EXPECT_EQ(std::memcmp(read_vectors.data(), vectors.data(), 2 * sizeof(dem::Vec3)), 0);
  EXPECT_EQ(reader.get<std::vector<std::uint8_t>>("small"), small);
  EXPECT_EQ(reader.get<std::vector<std::uint32_t>>("medium"), medium);
  EXPECT_EQ(reader.get<std::vector<std::uint64_t>>("large"), large);
  EXPECT_EQ(reader.get<std::vector<std::int32_t>>("negative"), negative);
  EXPECT_EQ(reader.get<std::vector<std::string>>("texts"), texts);
  EXPECT_EQ(reader.get<std::string>("text"), "subsection Press\n  set Speed = 1 m/s\nend\n");
  EXPECT_EQ(reader.get<std::string>("no_text"), "");
  EXPECT_TRUE(reader.get<std::vector<dem::Vec3>>("nothing").empty());
  EXPECT_TRUE(std::signbit(reader.get<double>("minus_zero")));
  EXPECT_EQ(reader.get<std::uint64_t>("count"), ~std::uint64_t{0});
  EXPECT_TRUE(reader.get<bool>("flag"));
  EXPECT_EQ(reader.get<dem::Vec3>("axis"), dem::Vec3(0.0, 0.0, 1.0));
  EXPECT_EQ(reader.datasets().size(), 15u);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.h5"}); // no temporary file is left
}

TEST(H5File, CarriesUnitAndDescriptionAndLinksToOtherFiles) {
  ScratchFolder const folder;
  write_sample(folder / "frame.h5");
  {
    H5Writer writer(folder / "run.h5");
    writer.write("curves/force", std::vector<double>{1.0});
    writer.describe("curves/force", "N", "force on the upper punch");
    writer.link("snapshots/first", "frame.h5", "/");
    writer.commit();
  }
  H5Reader const reader(folder / "run.h5");
  EXPECT_EQ(reader.attribute("curves/force", "unit"), "N");
  EXPECT_EQ(reader.attribute("curves/force", "description"), "force on the upper punch");
  EXPECT_EQ(reader.attribute("curves/force", "source"), "");
  EXPECT_EQ(reader.get<std::uint64_t>("snapshots/first/step"), 7u);
}

TEST(H5File, EqualContentGivesEqualBytesAndAnyHdf5ToolReadsThem) {
  ScratchFolder const folder;
  write_sample(folder / "a.h5");
  write_sample(folder / "b.h5");
  EXPECT_EQ(support::bytes_of(folder / "a.h5"), support::bytes_of(folder / "b.h5"));
  // Behind the library's back, as h5py or h5dump would.
  hid_t const file = H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  hid_t const set = H5Dopen2(file, "grains/radius", H5P_DEFAULT);
  std::vector<double> radius(3);
  EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, radius.data()), 0);
  EXPECT_EQ(radius, (std::vector<double>{1.0, 2.0, 3.0}));
  H5Dclose(set);
  H5Fclose(file);
}

TEST(H5File, RefusesEveryFlippedByte) {
  ScratchFolder const folder;
  std::string const file = (folder / "a.h5").string();
  write_sample(file);
  std::string const good = support::bytes_of(file);
  ASSERT_GT(good.size(), 512u);
  // In place: a file that is truncated and written again waits for the disk.
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  auto const put = [&](std::size_t place, char byte) {
    stream.seekp(static_cast<std::streamoff>(place)).put(byte).flush();
  };
  for (std::size_t i = 0; i < good.size(); ++i) {
    put(i, static_cast<char>(good[i] ^ (1 << (i % 8))));
    EXPECT_TRUE(message_of([&] { H5Reader{file}; }).starts_with(file + ": ")) << "byte " << i;
    put(i, good[i]);
  }
  EXPECT_EQ(H5Reader(file).get<std::uint64_t>("step"), 7u);
}

TEST(H5File, RefusesEveryTruncationAndAddition) {
  ScratchFolder const folder;
  write_sample(folder / "a.h5");
  std::string const good = support::bytes_of(folder / "a.h5");
  for (std::size_t n = good.size(); n-- > 0;) {
    std::filesystem::resize_file(folder / "a.h5", n);
    EXPECT_NE(message_of([&] { H5Reader{folder / "a.h5"}; }), "") << n << " bytes";
  }
  support::put_bytes(folder / "bad.h5", good + '\0');
  EXPECT_NE(message_of([&] { H5Reader{folder / "bad.h5"}; }).find("not as it was written"),
            std::string::npos);
}

TEST(H5File, NamesWhatIsWrongWithAFile) {
  ScratchFolder const folder;
  auto const message = [&](char const* name) {
    return message_of([&] { H5Reader{folder / name}; });
  };
  EXPECT_NE(message("missing.h5").find("there is no such file"), std::string::npos);
  EXPECT_NE(message(".").find("no regular file"), std::string::npos);
  support::put_bytes(folder / "empty.h5", "");
  EXPECT_NE(message("empty.h5").find("is empty"), std::string::npos);
  support::put_bytes(folder / "foreign.h5", "\x89HDF\r\n\x1a\n and more");
  EXPECT_NE(message("foreign.h5").find("no data file of presscheck"), std::string::npos);
  write_sample(folder / "a.h5");
  std::string bytes = support::bytes_of(folder / "a.h5");
  bytes[700] = static_cast<char>(bytes[700] ^ 1);
  support::put_bytes(folder / "flipped.h5", bytes);
  EXPECT_NE(message("flipped.h5").find("flipped.h5: checksum differs"), std::string::npos);
}

TEST(H5File, RefusesAnotherNameTypeOrShapeThanWasWritten) {
  ScratchFolder const folder;
  write_sample(folder / "a.h5");
  H5Reader const reader(folder / "a.h5");
  EXPECT_NE(message_of([&] { reader.get<double>("time"); }).find("time is not in the file"),
            std::string::npos);
  EXPECT_NE(message_of([&] { reader.get<std::vector<float>>("grains/radius"); }), "");
  EXPECT_NE(message_of([&] { reader.get<std::vector<dem::Vec3>>("grains/radius"); }), "");
  EXPECT_NE(message_of([&] { reader.get<double>("grains/radius"); }), "");
  EXPECT_NE(message_of([&] { reader.get<double>("step"); }), "");
  EXPECT_NE(message_of([&] { reader.get<std::vector<std::uint64_t>>("step"); }), "");
  EXPECT_NE(message_of([&] { reader.get<std::string>("step"); }), "");
  EXPECT_NE(message_of([&] { reader.get<std::vector<std::string>>("step"); }), "");
  EXPECT_NE(message_of([&] { reader.get<double>("grains"); }), "");
}

TEST(H5File, WithoutCommitLeavesTheOlderFileAndNoOther) {
  ScratchFolder const folder;
  write_sample(folder / "a.h5");
  std::string const before = support::bytes_of(folder / "a.h5");
  { H5Writer(folder / "a.h5").write("x", 1.0); }
  EXPECT_EQ(support::bytes_of(folder / "a.h5"), before);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.h5"});
}

TEST(AtomicFile, OnAFullDiskKeepsTheOlderFileAndSaysWhy) {
  ScratchFolder const folder;
  write_sample(folder / "a.h5");
  std::string const before = support::bytes_of(folder / "a.h5");
  std::string message;
  {
    support::SmallDisk const disk(4096);
    H5Writer writer(folder / "a.h5");
    writer.write("x", std::vector<double>(10000, 1.0));
    try {
      writer.commit();
    } catch (coupling::WriteFailed const& error) {
      message = error.what();
    }
  }
  EXPECT_NE(message.find("a.h5: cannot be written: File too large"), std::string::npos) << message;
  EXPECT_EQ(support::bytes_of(folder / "a.h5"), before);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.h5"});
  // The HDF5 library is none the worse for it.
  write_sample(folder / "b.h5");
  EXPECT_EQ(H5Reader(folder / "b.h5").get<std::uint64_t>("step"), 7u);
}

TEST(AtomicFile, RefusesAFolderThatIsNone) {
  ScratchFolder const folder;
  support::put_bytes(folder / "file", "x");
  auto const inside_a_file = folder / "file/a.h5";
  EXPECT_NE(message_of([&] { H5Writer{inside_a_file}; }).find("cannot be created: Not a directory"),
            std::string::npos);
  EXPECT_NE(
      message_of([&] { coupling::write_file(folder / "none/a.txt", "x"); }).find("No such file"),
      std::string::npos);
}

TEST(AtomicFile, DoesNotReplaceAFolder) {
  ScratchFolder const folder;
  std::filesystem::create_directory(folder / "summary.json");
  EXPECT_THROW(coupling::write_file(folder / "summary.json", "x"), coupling::WriteFailed);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"summary.json"});
}

TEST(AtomicFile, TextFilesReadBackAsWritten) {
  ScratchFolder const folder;
  for (std::string const text : {"", "a\nb\r\n", "\xff"}) {
    coupling::write_file(folder / "a.txt", text);
    EXPECT_EQ(coupling::read_file(folder / "a.txt"), text);
  }
  EXPECT_NE(message_of([&] { coupling::read_file(folder / "none"); }), "");
  EXPECT_NE(message_of([&] { coupling::read_file(folder.path()); }), "");
}
