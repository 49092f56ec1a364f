#include "coupling/record/h5.hpp"
#include "coupling/record/h5_id.hpp"
#include "coupling/record/seal.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>

namespace coupling {

struct H5Reader::File {
  std::filesystem::path name;
  H5Id id;

  [[noreturn]] void refuse(std::string const& dataset, std::string const& problem) const {
    throw dem::InvalidInput(
        fmt::format("{}: {} {}. Was it written by another version of presscheck?", name.string(),
                    dataset, problem));
  }

  H5Id dataset(std::string const& path) const {
    auto const id_or_error = H5Dopen2(id, path.c_str(), H5P_DEFAULT);
    if (id_or_error < 0)
      refuse(path, "is not in the file (it is needed)");
    return {id_or_error, H5Dclose};
  }
};

namespace {

/// Rank and extents, rank 2 at most; unused extents are 1.
struct Shape {
  int rank;
  std::array<hsize_t, 2> extents;
};

Shape shape_of(hid_t set) {
  H5Id const space(checked(H5Dget_space(set)), H5Sclose);
  int const rank = H5Sget_simple_extent_ndims(space);
  Shape shape{rank, {1, 1}};
  if (rank == 1 || rank == 2)
    checked(H5Sget_simple_extent_dims(space, shape.extents.data(), nullptr));
  return shape;
}

bool has_type(hid_t set, H5Element element) {
  H5Id const type(checked(H5Dget_type(set)), H5Tclose);
  return H5Tequal(type, native_type(element)) > 0;
}

/// Length of a fixed-length string type, 0 if the type is another.
std::size_t text_length(hid_t type) {
  bool const is_text = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
  return is_text ? H5Tget_size(type) : 0;
}

std::string without_padding(char const* text, std::size_t length) {
  while (length > 0 && text[length - 1] == '\0')
    --length;
  return {text, length};
}

herr_t collect_dataset(hid_t, char const* name, H5O_info_t const* info, void* names) {
  if (info->type == H5O_TYPE_DATASET)
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

hid_t open_verified(std::filesystem::path const& name) {
  silence_hdf5();
  verify_seal(name);
  hid_t const id = H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  VALIDATE(id >= 0,
           fmt::format("{}: is sealed as ours but holds no HDF5 data. Was it put together by hand?",
                       name.string()));
  return id;
}

} // namespace

H5Reader::H5Reader(std::filesystem::path const& name)
    : file_(new File{name, H5Id(open_verified(name), H5Fclose)}) {}
H5Reader::~H5Reader() = default;
H5Reader::H5Reader(H5Reader&&) noexcept = default;

std::filesystem::path const& H5Reader::name() const {
  return file_->name;
}

bool H5Reader::has(std::string const& name) const {
  hid_t const set = H5Dopen2(file_->id, name.c_str(), H5P_DEFAULT);
  if (set >= 0)
    H5Dclose(set);
  return set >= 0;
}

std::vector<std::string> H5Reader::datasets() const {
  std::vector<std::string> names;
  checked(
      H5Ovisit2(file_->id, H5_INDEX_NAME, H5_ITER_INC, collect_dataset, &names, H5O_INFO_BASIC));
  std::ranges::sort(names);
  return names;
}

std::size_t H5Reader::n_rows(std::string const& name, H5Element element) const {
  H5Id const set = file_->dataset(name);
  if (!has_type(set, element))
    file_->refuse(name, "has another number type than expected");
  Shape const shape = shape_of(set);
  bool const is_table =
      shape.rank == (element.columns == 1 ? 1 : 2) && shape.extents[1] == element.columns;
  if (!is_table)
    file_->refuse(name, fmt::format("is no array of {} columns", element.columns));
  // Extents are only a claim until the bytes are there; memory is taken for what the file holds.
  hsize_t const bytes = shape.extents[0] * element.columns * H5Tget_size(native_type(element));
  if (H5Dget_storage_size(set) != bytes)
    file_->refuse(name, "holds fewer values than it claims");
  return shape.extents[0];
}

void H5Reader::read_array(std::string const& name, H5Element element, void* data) const {
  if (n_rows(name, element) == 0)
    return;
  H5Id const set = file_->dataset(name);
  if (H5Dread(set, native_type(element), H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
    file_->refuse(name, "cannot be read");
}

void H5Reader::read_scalar(std::string const& name, H5Element element, void* data) const {
  H5Id const set = file_->dataset(name);
  if (!has_type(set, element))
    file_->refuse(name, "has another number type than expected");
  Shape const shape = shape_of(set);
  bool const fits = element.columns == 1 ? shape.rank == 0
                                         : shape.rank == 1 && shape.extents[0] == element.columns;
  if (!fits)
    file_->refuse(name, "is no single value");
  if (H5Dread(set, native_type(element), H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
    file_->refuse(name, "cannot be read");
}

std::string H5Reader::read_text(std::string const& name) const {
  H5Id const set = file_->dataset(name);
  H5Id const type(checked(H5Dget_type(set)), H5Tclose);
  std::size_t const length = text_length(type);
  if (length == 0 || shape_of(set).rank != 0 || H5Dget_storage_size(set) != length)
    file_->refuse(name, "is no text");
  std::string text(length, '\0');
  if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0)
    file_->refuse(name, "cannot be read");
  return without_padding(text.data(), length);
}

std::vector<std::string> H5Reader::read_texts(std::string const& name) const {
  H5Id const set = file_->dataset(name);
  H5Id const type(checked(H5Dget_type(set)), H5Tclose);
  std::size_t const width = text_length(type);
  Shape const shape = shape_of(set);
  if (width == 0 || shape.rank != 1 || H5Dget_storage_size(set) != width * shape.extents[0])
    file_->refuse(name, "is no list of texts");
  std::vector<char> table(width * shape.extents[0]);
  if (!table.empty() && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.data()) < 0)
    file_->refuse(name, "cannot be read");
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < shape.extents[0]; ++i)
    texts.push_back(without_padding(table.data() + i * width, width));
  return texts;
}

std::string H5Reader::attribute(std::string const& name, std::string const& key) const {
  hid_t const id = H5Aopen_by_name(file_->id, name.c_str(), key.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  if (id < 0)
    return {};
  H5Id const set(id, H5Aclose);
  H5Id const type(checked(H5Aget_type(set)), H5Tclose);
  std::string text(text_length(type), '\0');
  if (text.empty() || H5Aread(set, type, text.data()) < 0)
    file_->refuse(name + "@" + key, "is no text");
  return without_padding(text.data(), text.size());
}

} // namespace coupling
