#include "coupling/record/seal.hpp"

#include "coupling/record/checksum.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string_view>
#include <vector>

namespace coupling {
namespace {

constexpr std::string_view magic = "presscheck data 1\n";
constexpr char const* way_out = "Take an older restart or a copy, or start the run again?";

std::string seal_of(std::uint64_t length, std::uint64_t checksum) {
  std::string block = fmt::format("{}bytes {}\nchecksum {:016x}\n", magic, length, checksum);
  block.resize(seal_size, '\0');
  return block;
}

struct Body {
  std::uint64_t length = 0;
  std::uint64_t checksum = 0;
};

Body read_body(std::ifstream& stream) {
  std::vector<char> buffer(std::size_t{1} << 18); // a multiple of eight, as Checksum wants
  Body body;
  Checksum checksum;
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    auto const n = static_cast<std::size_t>(stream.gcount());
    checksum.add(std::as_bytes(std::span(buffer.data(), n)));
    body.length += n;
  }
  body.checksum = checksum.value();
  return body;
}

} // namespace

std::string make_seal(std::span<std::byte const> body) {
  Checksum checksum;
  checksum.add(body);
  return seal_of(body.size(), checksum.value());
}

void verify_seal(std::filesystem::path const& name) {
  std::string const file = name.string();
  std::error_code error;
  VALIDATE(std::filesystem::exists(name, error),
           fmt::format("{}: there is no such file. Is the path right?", file));
  // A pipe or a device would be waited for without end.
  VALIDATE(
      std::filesystem::is_regular_file(name, error),
      fmt::format("{}: is no regular file (a data file is expected). Is the path right?", file));
  std::ifstream stream(name, std::ios::binary);
  VALIDATE(stream.is_open(), fmt::format("{}: cannot be opened. Are its permissions right?", file));

  std::string block(seal_size, '\0');
  stream.read(block.data(), seal_size);
  auto const n = static_cast<std::size_t>(stream.gcount());
  VALIDATE(n > 0, fmt::format("{}: is empty (its writing was interrupted). {}", file, way_out));
  VALIDATE(
      block.starts_with(magic.substr(0, n)),
      fmt::format(
          "{}: is no data file of presscheck (its first line is not '{}'). Is it the right file?",
          file, magic.substr(0, magic.size() - 1)));
  VALIDATE(n == seal_size,
           fmt::format("{}: ends after {} bytes (the file is truncated). {}", file, n, way_out));

  unsigned long long length = 0, checksum = 0;
  VALIDATE(std::sscanf(block.c_str() + magic.size(), "bytes %llu\nchecksum %16llx\n", &length,
                       &checksum) == 2 &&
               block == seal_of(length, checksum),
           fmt::format("{}: its first {} bytes cannot be understood (the file is damaged). {}",
                       file, seal_size, way_out));
  Body const body = read_body(stream);
  VALIDATE(body.length == length,
           fmt::format("{}: holds {} bytes of data where {} were written (the file is {}). {}",
                       file, body.length, length,
                       body.length < length ? "truncated" : "not as it was written", way_out));
  VALIDATE(body.checksum == checksum,
           fmt::format(
               "{}: checksum differs, {:016x} where {:016x} was written (the file is damaged). {}",
               file, body.checksum, checksum, way_out));
}

} // namespace coupling
