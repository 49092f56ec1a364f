#pragma once

#include "coupling/record/h5.hpp"

#include <cstdint>
#include <utility>

/// What the two sources that speak to HDF5 share. An HDF5 identifier is a 64-bit integer, so its
/// header is not needed.
namespace coupling {

/// An HDF5 identifier, closed with the function that belongs to its kind.
class H5Id {
public:
  using Close = int (*)(std::int64_t);

  H5Id(std::int64_t id, Close close) : id_(id), close_(close) {}
  H5Id(H5Id&& other) noexcept : id_(other.release()), close_(other.close_) {}
  H5Id& operator=(H5Id&&) = delete;
  ~H5Id() {
    if (id_ >= 0)
      close_(id_);
  }

  operator std::int64_t() const { return id_; }
  std::int64_t release() { return std::exchange(id_, -1); }

private:
  std::int64_t id_;
  Close close_;
};

/// The result of a call that cannot fail unless memory ran out or we misuse HDF5.
/// @throws std::runtime_error with HDF5's own words if it is negative
std::int64_t checked(std::int64_t result);

/// Keeps HDF5 from printing its error stack to standard error: we say in our own words what is
/// wrong with a file.
void silence_hdf5();

/// HDF5's type for an element.
std::int64_t native_type(H5Element element);

} // namespace coupling
