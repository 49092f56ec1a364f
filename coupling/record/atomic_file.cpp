#include "coupling/record/atomic_file.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <sstream>
#include <system_error>

namespace coupling {
namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

/// The rename itself is on disk only when its folder is. Some file systems cannot sync a folder:
/// then nothing more can be done, and the file itself is safe, so the result is not looked at.
void sync_folder_of(std::filesystem::path const& name) {
  auto const folder = name.has_parent_path() ? name.parent_path() : std::filesystem::path(".");
  int const descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    return;
  ::fsync(descriptor);
  ::close(descriptor);
}

} // namespace

AtomicFile::AtomicFile(std::filesystem::path name)
    : name_(std::move(name)), temporary_(name_.string() + ".tmp") {
  descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  VALIDATE(descriptor_ >= 0,
           fmt::format(
               "{}: cannot be created: {} (nothing was written). Is the folder there and writable?",
               name_.string(), reason(errno)));
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0)
    ::close(descriptor_);
  if (!temporary_.empty())
    ::unlink(temporary_.c_str());
}

void AtomicFile::fail(int error) const {
  throw WriteFailed(fmt::format("{}: cannot be written: {} (an earlier file of this name is "
                                "unchanged). Free some space or write elsewhere?",
                                name_.string(), reason(error)));
}

void AtomicFile::write(std::span<std::byte const> bytes) {
  while (!bytes.empty()) {
    ssize_t const n = ::write(descriptor_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      fail(n < 0 ? errno : EIO);
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
}

void AtomicFile::commit() {
  // EINVAL: the target cannot be synced (a pipe, some network file systems); its bytes were
  // accepted all the same.
  if (::fsync(descriptor_) != 0 && errno != EINVAL)
    fail(errno);
  int const descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0)
    fail(errno);
  if (::rename(temporary_.c_str(), name_.c_str()) != 0)
    fail(errno);
  temporary_.clear();
  sync_folder_of(name_);
}

void write_file(std::filesystem::path const& name, std::string_view text) {
  AtomicFile file(name);
  file.write(text);
  file.commit();
}

std::string read_file(std::filesystem::path const& name) {
  std::error_code error;
  bool const is_file = std::filesystem::is_regular_file(name, error);
  VALIDATE(is_file,
           fmt::format(
               "{}: is no file that can be read (it is missing, or a folder). Is the path right?",
               name.string()));
  std::ifstream stream(name, std::ios::binary);
  std::ostringstream text;
  // Inserting an empty file's buffer would set the fail bit.
  if (stream.peek() != std::ifstream::traits_type::eof())
    text << stream.rdbuf();
  VALIDATE(!stream.bad() && text.good() && stream.is_open(),
           fmt::format("{}: cannot be read: {}. Are its permissions right?", name.string(),
                       reason(errno)));
  return std::move(text).str();
}

std::string shortest(double value) {
  std::array<char, 32> digits;
  auto const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

} // namespace coupling
