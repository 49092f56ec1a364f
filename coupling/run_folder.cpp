#include "coupling/press_output.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace coupling {
namespace {

namespace fs = std::filesystem;

/// The nearest folder upwards that exists: where a new folder would be made.
fs::path existing_ancestor(fs::path path) {
  path = fs::absolute(path);
  while (!fs::exists(path) && path.has_relative_path())
    path = path.parent_path();
  return path;
}

bool is_result(fs::path const& file) {
  static constexpr std::array names{"case.resolved.prm", "curves.csv", "summary.json", "run.h5",
                                    "grains.pvd",        "tools.pvd",  "report.html",  "geometry",
                                    "snapshots",         "observed"};
  auto const name = file.filename().string();
  for (auto const* known : names)
    if (name == known)
      return true;
  return (name.starts_with("restart_") && name.ends_with(".h5")) || name.ends_with("_stress.pvd");
}

} // namespace

void check_run_folder(fs::path const& folder, bool overwrite) {
  std::error_code error;
  bool const is_there = fs::exists(folder, error);
  VALIDATE(
      !is_there || fs::is_directory(folder, error),
      fmt::format("-o {}: is a file (results go into a folder). Another name?", folder.string()));
  auto const place = existing_ancestor(folder);
  VALIDATE(fs::is_directory(place, error) && access(place.c_str(), W_OK | X_OK) == 0,
           fmt::format("-o {}: cannot be written ({}: {}). Another folder?", folder.string(),
                       place.string(), std::strerror(errno)));
  VALIDATE(
      !is_there || overwrite || fs::is_empty(folder, error),
      fmt::format(
          "-o {}: is not empty (its results would be overwritten). Another folder, or --force?",
          folder.string()));
}

void clear_run_folder(fs::path const& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  VALIDATE(!error, fmt::format("-o {}: cannot be made ({}). Another folder?", folder.string(),
                               error.message()));
  std::vector<fs::path> old;
  for (auto const& entry : fs::directory_iterator(folder))
    if (is_result(entry.path()))
      old.push_back(entry.path());
  for (auto const& path : old)
    fs::remove_all(path, error);
}

} // namespace coupling
