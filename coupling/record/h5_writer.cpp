#include "coupling/record/atomic_file.hpp"
#include "coupling/record/h5.hpp"
#include "coupling/record/h5_id.hpp"
#include "coupling/record/seal.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <utility>

namespace coupling {
namespace {

/// In memory only: HDF5 cannot give up a file that it failed to write (it tries again until the
/// program ends).
hid_t create_in_memory() {
  silence_hdf5();
  H5Id const access(checked(H5Pcreate(H5P_FILE_ACCESS)), H5Pclose);
  checked(H5Pset_fapl_core(access, std::size_t{1} << 20, /*backing_store=*/0));
  H5Id const creation(checked(H5Pcreate(H5P_FILE_CREATE)), H5Pclose);
  checked(H5Pset_userblock(creation, seal_size));
  return checked(H5Fcreate("in memory", H5F_ACC_TRUNC, creation, access));
}

H5Id text_type(std::size_t length) {
  H5Id type(checked(H5Tcopy(H5T_C_S1)), H5Tclose);
  checked(
      H5Tset_size(type, std::max<std::size_t>(length, 1))); // HDF5 has no strings of length zero
  checked(H5Tset_strpad(type, H5T_STR_NULLPAD));
  checked(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

H5Id with_folders() {
  H5Id list(checked(H5Pcreate(H5P_LINK_CREATE)), H5Pclose);
  checked(H5Pset_create_intermediate_group(list, 1));
  return list;
}

void write_dataset(hid_t file, std::string const& name, hid_t type, hid_t space, void const* data,
                   bool is_empty) {
  H5Id const folders = with_folders();
  H5Id const creation(checked(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
  checked(H5Pset_obj_track_times(creation, false)); // the same content gives the same bytes
  H5Id const set(
      checked(H5Dcreate2(file, name.c_str(), type, space, folders, creation, H5P_DEFAULT)),
      H5Dclose);
  if (!is_empty)
    checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
}

} // namespace

struct H5Writer::File {
  AtomicFile target;
  H5Id id;
};

H5Writer::H5Writer(std::filesystem::path const& name)
    : file_(new File{.target = AtomicFile(name), .id = H5Id(create_in_memory(), H5Fclose)}) {}
H5Writer::~H5Writer() = default;
H5Writer::H5Writer(H5Writer&&) noexcept = default;

void H5Writer::write_scalar(std::string const& name, H5Element element, void const* data) {
  hsize_t const columns = element.columns;
  H5Id const space(
      checked(columns == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &columns, nullptr)),
      H5Sclose);
  write_dataset(file_->id, name, native_type(element), space, data, false);
}

void H5Writer::write_array(std::string const& name, H5Element element, std::size_t rows,
                           void const* data) {
  std::array<hsize_t, 2> const shape{rows, element.columns};
  H5Id const space(checked(H5Screate_simple(element.columns == 1 ? 1 : 2, shape.data(), nullptr)),
                   H5Sclose);
  write_dataset(file_->id, name, native_type(element), space, data, rows == 0);
}

void H5Writer::write_text(std::string const& name, std::string_view text) {
  H5Id const type = text_type(text.size());
  H5Id const space(checked(H5Screate(H5S_SCALAR)), H5Sclose);
  write_dataset(file_->id, name, type, space, text.empty() ? "" : text.data(), false);
}

void H5Writer::write_texts(std::string const& name, std::vector<std::string> const& texts) {
  std::size_t width = 1;
  for (auto const& text : texts)
    width = std::max(width, text.size());
  std::string table(texts.size() * width, '\0');
  for (std::size_t i = 0; i < texts.size(); ++i)
    std::ranges::copy(texts[i], table.begin() + static_cast<long>(i * width));
  hsize_t const rows = texts.size();
  H5Id const space(checked(H5Screate_simple(1, &rows, nullptr)), H5Sclose);
  write_dataset(file_->id, name, text_type(width), space, table.data(), texts.empty());
}

void H5Writer::attribute(std::string const& name, std::string const& key, std::string_view value) {
  H5Id const type = text_type(value.size());
  H5Id const space(checked(H5Screate(H5S_SCALAR)), H5Sclose);
  H5Id const set(checked(H5Acreate_by_name(file_->id, name.c_str(), key.c_str(), type, space,
                                           H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)),
                 H5Aclose);
  checked(H5Awrite(set, type, value.empty() ? "" : value.data()));
}

void H5Writer::describe(std::string const& name, std::string_view unit,
                        std::string_view description) {
  attribute(name, "unit", unit);
  attribute(name, "description", description);
}

void H5Writer::link(std::string const& name, std::filesystem::path const& other,
                    std::string const& target) {
  H5Id const folders = with_folders();
  checked(H5Lcreate_external(other.c_str(), target.c_str(), file_->id, name.c_str(), folders,
                             H5P_DEFAULT));
}

void H5Writer::commit() {
  checked(H5Fflush(file_->id, H5F_SCOPE_GLOBAL));
  // The in-memory driver hands out where its image is, so the image is not copied: a restart of
  // many grains would otherwise need its memory twice.
  void* handle = nullptr;
  checked(H5Fget_vfd_handle(file_->id, H5P_DEFAULT, &handle));
  auto const* const image = *static_cast<std::byte const* const*>(handle);
  // Without a buffer this only tells the length of the image, user block not counted; the memory
  // itself is larger.
  auto const size = static_cast<std::size_t>(checked(H5Fget_file_image(file_->id, nullptr, 0)));
  checked(std::memcmp(image + seal_size, "\x89HDF\r\n\x1a\n", 8) == 0 ? 0 : -1);

  std::span<std::byte const> const body(image + seal_size, size);
  file_->target.write(make_seal(body));
  file_->target.write(body);
  file_->target.commit();
  checked(H5Fclose(file_->id.release()));
}

} // namespace coupling
