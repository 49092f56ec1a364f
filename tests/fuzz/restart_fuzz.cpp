// clang-format off
// fuzz-build: coupling/record/atomic_file.cpp coupling/record/grains_check.cpp
// fuzz-build: coupling/record/h5_id.cpp coupling/record/h5_reader.cpp coupling/record/h5_writer.cpp
// fuzz-build: coupling/record/restart_file.cpp coupling/record/seal.cpp -lhdf5_openmpi -lfmt
// fuzz-build: -isystem /usr/include/hdf5/openmpi -isystem /usr/include/x86_64-linux-gnu/mpi
// clang-format on
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/restart_file.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// Takes numbers off the front of the input, zeros at its end.
class Input {
public:
  Input(std::uint8_t const* data, std::size_t size) : bytes_(data, size) {}

  template <class T> T take() {
    T value{};
    auto const n = std::min(sizeof(T), bytes_.size());
    std::memcpy(static_cast<void*>(&value), bytes_.data(), n);
    bytes_ = bytes_.subspan(n);
    return value;
  }

  template <class T> std::vector<T> take_array() {
    std::vector<T> values(take<std::uint8_t>() % 5);
    for (T& value : values)
      value = take<T>();
    return values;
  }

private:
  std::span<std::uint8_t const> bytes_;
};

char const* const fields[] = {"grains/position", "grains/velocity", "grains/spin", "grains/radius",
                              "grains/mass",     "grains/material", "grains/id",   "time"};

/// A whole restart file with fields of any type and length under the names that a reader expects.
void write_any_state(Input input, std::filesystem::path const& file) {
  coupling::H5Writer writer(file);
  writer.write("header/format", std::uint64_t{input.take<std::uint8_t>() % 2u});
  writer.write("header/program_version", std::string(input.take<std::uint8_t>(), 'v'));
  writer.write("header/case_text", std::string("set Title = x"));
  writer.write("header/stage", std::string());
  writer.write("header/step", input.take<std::uint64_t>());
  writer.write("header/time", input.take<double>());
  for (std::string const field : fields) {
    std::string const name = "state/" + field;
    switch (input.take<std::uint8_t>() % 8) {
    case 0:
      writer.write(name, input.take_array<double>());
      break;
    case 1:
      writer.write(name, input.take_array<std::uint8_t>());
      break;
    case 2:
      writer.write(name, input.take_array<std::uint32_t>());
      break;
    case 3:
      writer.write(name, input.take_array<float>());
      break;
    case 4:
      writer.write(name, input.take<double>());
      break;
    case 5:
      writer.write(name, std::string(input.take<std::uint8_t>(), 'x'));
      break;
    case 6:
      writer.write(name, input.take_array<dem::Vec3>());
      break;
    default:
      break; // the field is missing
    }
  }
  writer.commit();
}

void read_state(std::filesystem::path const& file) {
  coupling::StateReader reader(file);
  std::vector<dem::Vec3> vectors;
  std::vector<double> radius, mass;
  std::vector<std::uint8_t> material;
  std::vector<std::uint32_t> id;
  double time = 0.0;
  for (auto const* field : {"grains/position", "grains/velocity", "grains/spin"})
    reader(field, vectors);
  reader("grains/radius", radius);
  reader("grains/mass", mass);
  reader("grains/material", material);
  reader("grains/id", id);
  reader("time", time);
  reader.finish();
  for (std::uint32_t const i : id)
    if (i >= radius.size() || !(radius[i] > 0.0) || mass.size() != radius.size())
      std::abort();
}

} // namespace

/// Any bytes, and any state in a whole file, are either refused with InvalidInput, in one line, or
/// give grains. The first byte chooses. HDF5's own parser is not fed with damaged bytes, here as in
/// the program: the seal stands before it.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  static support::ScratchFolder const folder;
  if (size == 0)
    return 0;
  auto const file = folder / "restart_1.h5";
  if (data[0] % 2 == 0)
    support::put_bytes(file, {reinterpret_cast<char const*>(data + 1), size - 1});
  else
    write_any_state({data + 1, size - 1}, file);
  try {
    read_state(coupling::newest_restart(folder.path()).file);
  } catch (dem::InvalidInput const& refusal) {
    if (std::string_view(refusal.what()).find('\n') != std::string_view::npos)
      std::abort();
  }
  return 0;
}
