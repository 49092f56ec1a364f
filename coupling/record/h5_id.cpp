#include "coupling/record/h5_id.hpp"

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <type_traits>

namespace coupling {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t> && std::is_same_v<herr_t, int>);

/// The innermost entry of the error stack is the cause.
herr_t keep_first(unsigned depth, H5E_error2_t const* entry, void* text) {
  if (depth == 0 && entry->desc != nullptr)
    *static_cast<std::string*>(text) = entry->desc;
  return 0;
}

} // namespace

std::int64_t checked(std::int64_t result) {
  if (result >= 0)
    return result;
  std::string cause = "no cause given";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &cause);
  throw std::runtime_error(
      "HDF5: " + cause +
      ". This is a defect of presscheck or of the HDF5 library, please report it");
}

void silence_hdf5() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::int64_t native_type(H5Element element) {
  switch (element.kind) {
  case H5Element::Kind::u8:
    return H5T_NATIVE_UINT8;
  case H5Element::Kind::u32:
    return H5T_NATIVE_UINT32;
  case H5Element::Kind::u64:
    return H5T_NATIVE_UINT64;
  case H5Element::Kind::i32:
    return H5T_NATIVE_INT32;
  case H5Element::Kind::i64:
    return H5T_NATIVE_INT64;
  case H5Element::Kind::f32:
    return H5T_NATIVE_FLOAT;
  case H5Element::Kind::f64:
    return H5T_NATIVE_DOUBLE;
  }
  throw std::logic_error("unknown kind of HDF5 element");
}

} // namespace coupling
