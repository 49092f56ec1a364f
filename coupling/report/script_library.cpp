#include "coupling/report/script_library.hpp"

#include "coupling/report/html.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

namespace coupling {
namespace {

std::string read_library(std::filesystem::path const& file, char const* package) {
  std::ifstream in(file, std::ios::binary);
  VALIDATE(in, fmt::format("{}: cannot be read (the report carries this library inside). "
                           "Install it with: apt-get install {}?",
                           file.string(), package));
  std::string const code(std::istreambuf_iterator<char>(in), {});
  VALIDATE(!code.empty(), fmt::format("{}: is empty (the report carries this library inside). "
                                      "Install it anew with: apt-get install --reinstall {}?",
                                      file.string(), package));
  return escape_inline_script(code);
}

} // namespace

std::filesystem::path default_script_libraries() {
  return PRESSCHECK_JAVASCRIPT_DIR;
}

std::string read_three_js(std::filesystem::path const& libraries) {
  auto const folder = libraries / "three";
  auto const three = read_library(folder / "three.min.js", "libjs-three");
  return three + "\n" +
         read_library(folder / "examples/js/controls/OrbitControls.js", "libjs-three");
}

} // namespace coupling
