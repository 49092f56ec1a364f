#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace coupling {

/// A file could be created but not completed: the disk is full, a quota or a size limit is reached.
/// Not the input's fault, so the exit status is 1. Whatever stood under the final name before is
/// untouched.
struct WriteFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file that appears under its name complete or not at all: it is written as `name.tmp` in the
/// same folder, synced and renamed by `commit`. Without a commit (an exception on the way) the
/// temporary file is removed. A program that uses it ignores SIGXFSZ, so that a size limit arrives
/// as an error and not as a signal.
class AtomicFile {
public:
  /// @throws dem::InvalidInput if the temporary file cannot be created
  explicit AtomicFile(std::filesystem::path name);
  ~AtomicFile();
  AtomicFile(AtomicFile const&) = delete;
  AtomicFile& operator=(AtomicFile const&) = delete;

  /// @throws WriteFailed
  void write(std::span<std::byte const> bytes);
  void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

  /// @throws WriteFailed if the system could not keep the bytes or rename the file
  void commit();

private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path name_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
};

/// Replaces `name` by `text` in one go.
/// @throws dem::InvalidInput, WriteFailed
void write_file(std::filesystem::path const& name, std::string_view text);

/// The whole of a text file.
/// @throws dem::InvalidInput if it cannot be read
std::string read_file(std::filesystem::path const& name);

/// A finite number in the fewest digits that read back to the same bits; `nan`, `inf` and `-inf`
/// otherwise.
std::string shortest(double value);

} // namespace coupling
