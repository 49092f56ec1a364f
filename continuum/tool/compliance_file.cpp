// The only file of continuum/ that knows HDF5: an operator as one dataset with its key and
// checksum.
#include "continuum/expect.hpp"
#include "continuum/hash.hpp"
#include "continuum/tool/interface_compliance.hpp"

#include <hdf5.h>

#include <unistd.h>

namespace continuum {

namespace {
constexpr char const* dataset_name = "compliance";
constexpr std::uint64_t format = 0x70632d636f6d7031; // "pc-comp1"

class Handle {
public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0)
      close_(id_);
  }
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
  operator hid_t() const { return id_; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

std::uint64_t checksum(Eigen::MatrixXd const& matrix, std::uint64_t key) {
  return Fnv().add(key).add_bytes(std::as_bytes(std::span(matrix.data(), matrix.size()))).value();
}

bool write_number(hid_t object, char const* name, std::uint64_t value) {
  Handle const space(H5Screate(H5S_SCALAR), H5Sclose);
  Handle const attribute(H5Acreate2(object, name, H5T_STD_U64LE, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  return attribute >= 0 && H5Awrite(attribute, H5T_NATIVE_UINT64, &value) >= 0;
}

bool write_text(hid_t object, char const* name, std::string const& value) {
  Handle const type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, value.size());
  Handle const space(H5Screate(H5S_SCALAR), H5Sclose);
  Handle const attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute >= 0 && H5Awrite(attribute, type, value.data()) >= 0;
}

std::uint64_t read_number(hid_t object, char const* name) {
  std::uint64_t value = 0;
  Handle const attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (attribute < 0 || H5Aread(attribute, H5T_NATIVE_UINT64, &value) < 0)
    return 0;
  return value;
}

bool write(std::filesystem::path const& file, Eigen::MatrixXd const& matrix, std::uint64_t key) {
  Handle const h5(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  hsize_t const n = matrix.rows();
  hsize_t const shape[] = {n, n};
  Handle const space(H5Screate_simple(2, shape, nullptr), H5Sclose);
  if (h5 < 0 || space < 0)
    return false;
  Handle const data(
      H5Dcreate2(h5, dataset_name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  return data >= 0 &&
         H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, matrix.data()) >= 0 &&
         write_number(data, "format", format) && write_number(data, "key", key) &&
         write_number(data, "checksum", checksum(matrix, key)) && write_text(data, "unit", "m/N") &&
         H5Fflush(h5, H5F_SCOPE_GLOBAL) >= 0;
}

// HDF5 prints its error stack on its own account; here the message is ours.
struct QuietHdf5 {
  QuietHdf5() {
    H5Eget_auto2(H5E_DEFAULT, &print, &data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, print, data); }
  H5E_auto2_t print;
  void* data;
};
} // namespace

void InterfaceCompliance::save(std::filesystem::path const& file) const {
  QuietHdf5 const quiet;
  // Cases of a study may write the same operator at the same time: each to its own name first.
  std::filesystem::path const unfinished = file.string() + ".part" + std::to_string(::getpid());
  std::error_code error;
  bool const is_written = write(unfinished, matrix_, key_);
  if (is_written)
    std::filesystem::rename(unfinished, file, error);
  if (!is_written || error) {
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw InvalidInput(file.string() + ": the compliance cannot be written. Does the folder exist, "
                                       "and has the disk room?");
  }
}

InterfaceCompliance InterfaceCompliance::load(std::filesystem::path const& file,
                                              std::uint64_t key) {
  QuietHdf5 const quiet;
  std::string const name = file.string();
  Handle const h5(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  VALIDATE(h5 >= 0, name + ": no readable HDF5 file (missing, cut off or of another kind). Delete "
                           "it and condense anew?");
  Handle const data(H5Dopen2(h5, dataset_name, H5P_DEFAULT), H5Dclose);
  VALIDATE(data >= 0 && read_number(data, "format") == format,
           name + ": holds no compliance of this format (written by something else). Is it the "
                  "right file?");
  VALIDATE(read_number(data, "key") == key,
           name + ": belongs to another tool (mesh, material, supports or surface differ). Give "
                  "each tool its own file?");
  Handle const space(H5Dget_space(data), H5Sclose);
  hsize_t shape[2] = {0, 0};
  bool const is_square = H5Sget_simple_extent_ndims(space) == 2 &&
                         H5Sget_simple_extent_dims(space, shape, nullptr) == 2 &&
                         shape[0] == shape[1] && shape[0] % 3 == 0 && shape[0] < 100000;
  Eigen::MatrixXd matrix(is_square ? shape[0] : 0, is_square ? shape[1] : 0);
  VALIDATE(is_square &&
               H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, matrix.data()) >=
                   0 &&
               checksum(matrix, key) == read_number(data, "checksum"),
           name + ": is damaged (its checksum does not fit). Delete it and condense anew?");
  return InterfaceCompliance(std::move(matrix), key);
}

} // namespace continuum
