#pragma once

#include "dem/vec3.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// HDF5 files of presscheck. Each begins with a text block of 512 bytes (HDF5 calls it the user
/// block, its tools skip it) that holds the length and a checksum of all that follows. A reader
/// verifies them before HDF5 sees the file: HDF5 trusts what it parses, we do not trust disks.
namespace coupling {

/// How one item of an array is stored.
struct H5Element {
  enum class Kind : std::uint8_t { u8, u32, u64, i32, i64, f32, f64 };
  Kind kind;
  std::size_t columns; ///< 1, or 3 for Vec3
};

template <class T> constexpr H5Element h5_element() {
  using enum H5Element::Kind;
  if constexpr (std::same_as<T, dem::Vec3>)
    return {f64, 3};
  else if constexpr (std::same_as<T, double>)
    return {f64, 1};
  else if constexpr (std::same_as<T, float>)
    return {f32, 1};
  else if constexpr (std::unsigned_integral<T> && sizeof(T) == 8)
    return {u64, 1};
  else if constexpr (std::unsigned_integral<T> && sizeof(T) == 4)
    return {u32, 1};
  else if constexpr (std::unsigned_integral<T> && sizeof(T) == 1)
    return {u8, 1};
  else if constexpr (std::signed_integral<T> && sizeof(T) == 8)
    return {i64, 1};
  else if constexpr (std::signed_integral<T> && sizeof(T) == 4)
    return {i32, 1};
  else
    static_assert(sizeof(T) == 0, "this type has no form in our HDF5 files");
}

/// One number or one Vec3.
template <class T>
concept H5Scalar = std::is_arithmetic_v<T> || std::same_as<T, dem::Vec3>;

/// Builds the file in memory and puts it under its name by `commit`, complete or not at all
/// (AtomicFile). HDF5 never writes to the disk itself: it cannot recover from a full one.
class H5Writer {
public:
  /// @throws dem::InvalidInput if no file can be created there
  explicit H5Writer(std::filesystem::path const& name);
  ~H5Writer();
  H5Writer(H5Writer&&) noexcept;

  /// Writes a number, a Vec3, a string, an array of these. Folders in `name` ("grains/position")
  /// are made.
  template <class T> void write(std::string const& name, T const& value) {
    if constexpr (std::convertible_to<T const&, std::string_view>)
      write_text(name, value);
    else if constexpr (std::same_as<T, std::vector<std::string>>)
      write_texts(name, value);
    else if constexpr (H5Scalar<T>)
      write_scalar(name, h5_element<T>(), &value);
    else
      write_array(name, h5_element<std::ranges::range_value_t<T>>(), std::ranges::size(value),
                  std::ranges::data(value));
  }

  /// Attributes `unit` and `description` of what stands under `name`.
  void describe(std::string const& name, std::string_view unit, std::string_view description);
  void attribute(std::string const& name, std::string const& key, std::string_view value);

  /// `name` becomes a link to `target` inside the file `other`, a path relative to this file's
  /// folder.
  void link(std::string const& name, std::filesystem::path const& other, std::string const& target);

  /// Nothing can be written afterwards.
  /// @throws WriteFailed
  void commit();

private:
  void write_scalar(std::string const& name, H5Element element, void const* data);
  void write_array(std::string const& name, H5Element element, std::size_t rows, void const* data);
  void write_text(std::string const& name, std::string_view text);
  void write_texts(std::string const& name, std::vector<std::string> const& texts);

  struct File;
  std::unique_ptr<File> file_;
};

/// Reads what H5Writer wrote, to the bit. Names, types and shapes must be those that were written.
class H5Reader {
public:
  /// @throws dem::InvalidInput if the file is missing, foreign, truncated or damaged
  explicit H5Reader(std::filesystem::path const& name);
  ~H5Reader();
  H5Reader(H5Reader&&) noexcept;

  std::filesystem::path const& name() const;
  bool has(std::string const& name) const;

  /// Names of all datasets, sorted; links into other files are not followed.
  std::vector<std::string> datasets() const;

  /// @throws dem::InvalidInput if there is no `name` or it has another type or shape
  template <class T> void read(std::string const& name, T& value) const {
    if constexpr (std::same_as<T, std::string>)
      value = read_text(name);
    else if constexpr (std::same_as<T, std::vector<std::string>>)
      value = read_texts(name);
    else if constexpr (H5Scalar<T>)
      read_scalar(name, h5_element<T>(), &value);
    else {
      auto constexpr element = h5_element<std::ranges::range_value_t<T>>();
      value.resize(n_rows(name, element));
      read_array(name, element, value.data());
    }
  }

  template <class T> T get(std::string const& name) const {
    T value;
    read(name, value);
    return value;
  }

  /// An attribute of `name`, empty if there is none.
  std::string attribute(std::string const& name, std::string const& key) const;

private:
  std::size_t n_rows(std::string const& name, H5Element element) const;
  void read_scalar(std::string const& name, H5Element element, void* data) const;
  void read_array(std::string const& name, H5Element element, void* data) const;
  std::string read_text(std::string const& name) const;
  std::vector<std::string> read_texts(std::string const& name) const;

  struct File;
  std::unique_ptr<File> file_;
};

} // namespace coupling
