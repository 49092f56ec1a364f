#include "coupling/record/restart_file.hpp"

#include "coupling/record/grains_check.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

namespace coupling {
namespace {

/// Raised when the meaning of a field changes; a new or dropped field shows by itself.
constexpr std::uint64_t format_version = 1;

RestartHeader read_header(H5Reader const& file) {
  auto const format = file.has("header/format") ? file.get<std::uint64_t>("header/format") : 0;
  VALIDATE(format != 0, fmt::format("{}: is no restart file (it has no header). Is it a run.h5?",
                                    file.name().string()));
  VALIDATE(format == format_version,
           fmt::format("{}: format = {} (this program reads {}). Use the program that wrote it?",
                       file.name().string(), format, format_version));
  RestartHeader header;
  file.read("header/program_version", header.program_version);
  file.read("header/case_text", header.case_text);
  file.read("header/stage", header.stage);
  file.read("header/step", header.step);
  file.read("header/time", header.time);
  VALIDATE(std::isfinite(header.time) && header.time >= 0.0,
           fmt::format("{}: time = {} s (no time of a run). Take an older restart?",
                       file.name().string(), header.time));
  return header;
}

/// The step in the name of a rolling restart.
std::optional<std::uint64_t> step_of(std::filesystem::path const& file) {
  constexpr std::string_view head = "restart_", tail = ".h5";
  std::string const name = file.filename().string();
  if (!name.starts_with(head) || !name.ends_with(tail) || name.size() <= head.size() + tail.size())
    return {};
  std::uint64_t step = 0;
  char const* const end = name.data() + name.size() - tail.size();
  auto const [stop, error] = std::from_chars(name.data() + head.size(), end, step);
  return error == std::errc() && stop == end ? std::optional(step) : std::nullopt;
}

std::vector<std::filesystem::path> restart_files(std::filesystem::path const& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (auto const& entry : std::filesystem::directory_iterator(folder, error)) {
    std::string const name = entry.path().filename().string();
    if (name.starts_with("restart_") && name.ends_with(".h5"))
      files.push_back(entry.path());
  }
  VALIDATE(!error, fmt::format("{}: cannot be listed: {}. Is it a run folder?", folder.string(),
                               error.message()));
  std::ranges::sort(files);
  return files;
}

} // namespace

StateWriter::StateWriter(std::filesystem::path const& file, RestartHeader const& header)
    : file_(file), label_(file.string()) {
  file_.write("header/format", format_version);
  file_.write("header/program_version", header.program_version);
  file_.write("header/case_text", header.case_text);
  file_.write("header/stage", header.stage);
  file_.write("header/step", header.step);
  file_.write("header/time", header.time);
  file_.describe("header/time", "s", "simulated time of this state");
}

void StateWriter::check_finite(std::string const& name, std::vector<double> const& values) {
  if (!name.starts_with("grains/"))
    return;
  auto const bad =
      std::ranges::find_if_not(values, [](double value) { return std::isfinite(value); });
  if (bad != values.end())
    throw dem::PhysicsGuard(
        fmt::format("{}: not written: {}[{}] = {} (the state is broken). Lower the time step?",
                    label_, name, bad - values.begin(), *bad));
}

void StateWriter::check_finite(std::string const& name, std::vector<dem::Vec3> const& values) {
  if (!name.starts_with("grains/"))
    return;
  auto const bad =
      std::ranges::find_if_not(values, [](dem::Vec3 const& value) { return value.allFinite(); });
  if (bad != values.end())
    throw dem::PhysicsGuard(fmt::format(
        "{}: not written: {}[{}] = ({}, {}, {}) (the state is broken). Lower the time step?",
        label_, name, bad - values.begin(), bad->x(), bad->y(), bad->z()));
}

StateReader::StateReader(std::filesystem::path const& file)
    : file_(file), header_(read_header(file_)) {
  for (auto const& name : file_.datasets())
    if (name.starts_with("state/"))
      unread_.insert(name);
  if (unread_.contains("state/grains/position"))
    check_grains(file_, "state/grains/");
}

void StateReader::finish() const {
  VALIDATE(
      unread_.empty(),
      fmt::format("{}: holds {} which this run does not know (it was written by another version "
                  "or for another case). Resume with the program that wrote it?",
                  file_.name().string(), fmt::join(unread_, ", ")));
}

std::filesystem::path rolling_restart(std::filesystem::path const& folder, std::uint64_t step) {
  return folder / fmt::format("restart_{}.h5", step);
}

std::filesystem::path stage_restart(std::filesystem::path const& folder, std::string const& stage) {
  std::string name = stage;
  auto const is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_';
  };
  std::ranges::replace_if(
      name, [&](char c) { return !is_plain(static_cast<unsigned char>(c)); }, '_');
  return folder / fmt::format("restart_stage_{}.h5", name);
}

void prune_restarts(std::filesystem::path const& folder, std::size_t n_kept) {
  std::vector<std::pair<std::uint64_t, std::filesystem::path>> rolling;
  for (auto const& file : restart_files(folder))
    if (auto const step = step_of(file))
      rolling.emplace_back(*step, file);
  std::ranges::sort(rolling, std::greater());
  std::error_code ignored; // a restart too many does no harm
  for (std::size_t i = n_kept; i < rolling.size(); ++i)
    std::filesystem::remove(rolling[i].second, ignored);
}

FoundRestart newest_restart(std::filesystem::path const& folder) {
  FoundRestart newest;
  for (auto const& file : restart_files(folder)) {
    try {
      RestartHeader header = StateReader(file).header();
      if (newest.file.empty() || header.step > newest.header.step) {
        newest.file = file;
        newest.header = std::move(header);
      }
    } catch (dem::InvalidInput const& reason) {
      newest.refused.emplace_back(reason.what());
    }
  }
  VALIDATE(!newest.file.empty(),
           fmt::format("{}: has no restart file to go on from{}{}. Start the run again?",
                       folder.string(), newest.refused.empty() ? "" : "; ",
                       fmt::join(newest.refused, "; ")));
  return newest;
}

} // namespace coupling
