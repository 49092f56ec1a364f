#include "coupling/measured/read_measured.hpp"

#include "coupling/measured/measured_file.hpp"
#include "coupling/measured/run_reader.hpp"
#include "coupling/quote.hpp"
#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace coupling::measured {
namespace {

namespace fs = std::filesystem;

/// A file's name as one would write it without detours: `a/../run1.csv` is run1.csv.
std::string plain_name(std::string const& file, std::string const& where) {
  fs::path const path = fs::path(file).lexically_normal();
  bool const leaves = path.is_absolute() || path.empty() || *path.begin() == "..";
  VALIDATE(!leaves && path.has_filename() && path != ".",
           fmt::format("{}/file = {}: leaves the folder (measured data hold all their files). Copy "
                       "it into the folder?",
                       where, quote(file)));
  return path.generic_string();
}

/// No file is two runs, or a run and the position of another.
void check_files(std::vector<RunEntry>& runs) {
  std::map<std::string, std::string> users;
  for (auto& entry : runs)
    for (auto* file : {&entry.run.file, &entry.position_file}) {
      if (file == &entry.position_file && file->empty())
        continue;
      if (entry.has_file || file == &entry.position_file)
        *file = plain_name(*file, entry.where);
      auto const [user, is_new] = users.emplace(*file, entry.where);
      VALIDATE(is_new, fmt::format("{}/file = {}: is named twice (first at {}; one pressing is one "
                                   "run). Remove one?",
                                   entry.where, quote(*file), user->second));
    }
}

/// What the set of runs can and cannot show.
void note_roles(MeasuredData& data, std::string const& name) {
  auto const n_held_out = std::ranges::count(data.runs, Role::held_out, &Run::role);
  VALIDATE(n_held_out < std::ssize(data.runs),
           fmt::format("{}: runs: all are held out (nothing is left to fit). Give one the role "
                       "\"fit\"?",
                       name));
  auto const note = [&](std::string what) { data.decisions.push_back({"", 0, std::move(what)}); };
  if (data.runs.size() == 1)
    note("one run only: it is fitted, no gain on unseen data can be measured, and scatter between "
         "pressings is not known");
  else if (n_held_out == 0)
    note("no run is held out: no gain on unseen data can be measured");
  for (auto const& group : repeats(data)) {
    auto const is_held_out = [&](std::size_t k) { return data.runs[k].role == Role::held_out; };
    auto const unseen = std::ranges::find_if(group, is_held_out);
    auto const seen = std::ranges::find_if_not(group, is_held_out);
    if (unseen != group.end() && seen != group.end())
      note(fmt::format("held-out run {} repeats the protocol of {}: its gain shows nothing of "
                       "other protocols",
                       data.runs[*unseen].file, data.runs[*seen].file));
  }
}

void note_unused_channels(MeasuredData& data) {
  auto const is_unused = [&](Channel const& channel) {
    return std::ranges::none_of(data.runs, [&](Run const& run) {
      return run.has(channel.name) || !run.has_curve(); // numbers have these uncertainties, too
    });
  };
  for (auto const& channel : data.channels)
    if (is_unused(channel))
      data.decisions.push_back(
          {"", 0, fmt::format("channel {} is described, but no run holds it", channel.name)});
}

/// Decisions that an earlier reading took as well are kept once.
void remove_twins(std::vector<Decision>& decisions) {
  std::vector<Decision> kept;
  for (auto& decision : decisions)
    if (std::ranges::find(kept, decision) == kept.end())
      kept.push_back(std::move(decision));
  decisions = std::move(kept);
}

} // namespace

MeasuredData parse_measured(std::string_view json, std::string const& folder,
                            FileText const& text_of) {
  auto const name = folder + "measured.json";
  MeasuredFile file = parse_measured_file(json, name);
  check_files(file.runs);
  MeasuredData data{.sample = file.sample,
                    .channels = std::move(file.channels),
                    .gap_source = file.gap_source,
                    .runs = {},
                    .decisions = std::move(file.decisions)};
  for (auto const& entry : file.runs)
    data.runs.push_back(entry.has_file ? read_run_series(entry, folder, text_of, data)
                                       : read_run_numbers(entry, data));
  note_roles(data, name);
  note_unused_channels(data);
  remove_twins(data.decisions);
  return data;
}

MeasuredData read_measured(fs::path const& folder) {
  auto const json = folder / "measured.json";
  auto const home = fs::weakly_canonical(folder);
  auto const text_of = [&](std::string const& file) {
    // A link may lead out of the folder although its name does not.
    auto const at = fs::weakly_canonical(folder / file);
    VALIDATE(std::ranges::mismatch(home, at).in1 == home.end(),
             fmt::format("{}: is a link to {}, outside the folder (measured data hold all their "
                         "files). Copy it into the folder?",
                         (folder / file).string(), at.string()));
    return read_file(folder / file);
  };
  return parse_measured(read_file(json), (folder / "").string(), text_of);
}

} // namespace coupling::measured
