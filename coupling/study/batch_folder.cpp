#include "coupling/study/batch_folder.hpp"

#include "coupling/press_output.hpp"
#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <utility>

namespace coupling::study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array states{
    std::pair{RunState::waiting, "waiting"}, std::pair{RunState::running, "running"},
    std::pair{RunState::done, "done"}, std::pair{RunState::stopped, "stopped"},
    std::pair{RunState::failed, "failed"}};

/// A file of ours as JSON; null if it is not there or cannot be understood (then it is made anew).
Json read_own_json(fs::path const& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    return nullptr;
  return Json::parse(read_file(file), nullptr, false);
}

/// Runs of an earlier plan with their hashes.
std::map<std::string, std::string> planned_before(fs::path const& folder) {
  std::map<std::string, std::string> hashes;
  auto const plan = read_own_json(folder / "plan.json");
  if (plan.is_object())
    for (auto const& run : plan.value("runs", Json::array()))
      hashes[run.value("run", "")] = run.value("case", "");
  return hashes;
}

FileLock open_lock(fs::path const& file, int how) {
  int const descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  VALIDATE(descriptor >= 0, fmt::format("{}: cannot be opened: {}. Is the folder writable?",
                                        file.string(), std::strerror(errno)));
  int result = 0;
  do
    result = ::flock(descriptor, how);
  while (result != 0 && errno == EINTR);
  int const error = errno;
  if (result == 0)
    return FileLock(descriptor);
  ::close(descriptor);
  VALIDATE(error == EWOULDBLOCK,
           fmt::format("{}: cannot be locked: {} (runs are shared by locks). Put the study on "
                       "another file system?",
                       file.string(), std::strerror(error)));
  return {};
}

/// Moves what belongs to another case out of the way.
void set_aside(BatchFolder const& folder, std::string const& id, std::string const& hash) {
  auto const place = folder.path() / "replaced" / fmt::format("{}-{}", id, hash.substr(0, 8));
  std::error_code error;
  fs::remove_all(place, error);
  fs::create_directories(place, error);
  for (auto const& [from, to] :
       {std::pair{folder.run(id), place / "run"}, std::pair{folder.log(id), place / "log"},
        std::pair{folder.path() / "states" / (id + ".json"), place / "state.json"},
        std::pair{folder.case_of(id), place / "case.prm"}})
    if (fs::exists(from))
      fs::rename(from, to);
}

Json to_json(StudyRun const& run, RunEstimate const& estimate) {
  return {{"run", run.id},
          {"case", run.hash},
          {"grains", estimate.grains},
          {"steps", estimate.steps},
          {"bytes", estimate.bytes},
          {"seconds_per_particle_step", estimate.seconds_per_particle_step}};
}

} // namespace

char const* word(RunState state) {
  return std::ranges::find(states, state, &std::pair<RunState, char const*>::first)->second;
}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0)
    ::close(descriptor_);
}

BatchFolder::BatchFolder(fs::path const& path) : path_(fs::absolute(path).lexically_normal()) {
  if (path_.filename().empty())
    path_ = path_.parent_path();
}

void BatchFolder::check(StudyPlan const& plan, bool overwrite) const {
  // The lock is the first thing that a study makes: whoever finds it may have come while another
  // process is still writing the plan, or was killed then.
  if (!fs::exists(path_ / "study.lock"))
    return check_run_folder(path_, overwrite);
  auto const before = planned_before(path_);
  bool const shares_a_run = std::ranges::any_of(plan.runs, [&](StudyRun const& run) {
    auto const found = before.find(run.id);
    return found != before.end() && found->second == run.hash;
  });
  VALIDATE(before.empty() || shares_a_run || overwrite,
           fmt::format("-o {}: holds another study (none of its {} runs is one of the {} of {}). "
                       "Another folder, or --force?",
                       path_.string(), before.size(), plan.runs.size(), plan.study.file.string()));
}

FileLock BatchFolder::lock_study() const {
  return open_lock(path_ / "study.lock", LOCK_EX);
}

void BatchFolder::prepare(StudyFile const& study, std::vector<StudyRun> const& runs,
                          std::vector<RunEstimate> const& estimates) const {
  std::error_code error;
  fs::create_directories(path_, error);
  VALIDATE(!error, fmt::format("-o {}: cannot be made ({}). Another folder?", path_.string(),
                               error.message()));
  auto const lock = lock_study();
  for (auto const* part : {"cases", "logs", "states", "locks", "runs"})
    fs::create_directories(path_ / part);
  Json json;
  json["study"] = study.title;
  json["version"] = PRESSCHECK_VERSION;
  json["runs"] = Json::array();
  for (std::size_t k = 0; k < runs.size(); ++k)
    json["runs"].push_back(to_json(runs[k], estimates[k]));
  if (!study.is_data())
    add_cases(runs);
  write_file(path_ / "study.resolved.prm", study.resolved_text);
  write_file(path_ / "plan.json", json.dump(1) + "\n");
}

void BatchFolder::add_cases(std::vector<StudyRun> const& runs) const {
  for (auto const& run : runs) {
    auto const file = case_of(run.id);
    if (fs::exists(file)) {
      auto const old = hash_of(read_file(file));
      if (old == run.hash)
        continue;
      auto const lock = try_lock(run.id);
      VALIDATE(
          static_cast<bool>(lock),
          fmt::format("{}: is running with another case (it belongs to an earlier form of this "
                      "study). Wait for it, or another folder?",
                      this->run(run.id).string()));
      set_aside(*this, run.id, old);
    }
    write_file(file, run.case_text);
  }
}

std::vector<std::optional<RunEstimate>>
BatchFolder::kept_estimates(std::vector<StudyRun> const& runs) const {
  std::map<std::string, RunEstimate> kept; // by hash: a case's size does not depend on its name
  auto const plan = read_own_json(path_ / "plan.json");
  if (plan.is_object())
    for (auto const& run : plan.value("runs", Json::array()))
      kept[run.value("case", "")] = {.grains = run.value("grains", 0.0),
                                     .steps = run.value("steps", 0.0),
                                     .bytes = run.value("bytes", 0.0),
                                     .seconds_per_particle_step =
                                         run.value("seconds_per_particle_step", 0.0)};
  std::vector<std::optional<RunEstimate>> found(runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (auto const one = kept.find(runs[k].hash); one != kept.end())
      found[k] = one->second;
  return found;
}

RunRecord BatchFolder::record(StudyRun const& run) const {
  auto const json = read_own_json(path_ / "states" / (run.id + ".json"));
  RunRecord record{.hash = run.hash, .reason = {}};
  if (!json.is_object() || json.value("case", "") != run.hash)
    return record;
  auto const name = json.value("state", "waiting");
  for (auto const& [state, known] : states)
    if (name == known)
      record.state = state;
  record.exit_status = json.value("exit_status", 0);
  record.reason = json.value("reason", "");
  record.attempts = json.value("attempts", 0);
  record.cpu_seconds = json.value("cpu_seconds", 0.0);
  record.wall_seconds = json.value("wall_seconds", 0.0);
  // Its results may have been removed by hand.
  if (record.state == RunState::done && !fs::exists(this->run(run.id) / "summary.json"))
    record.state = RunState::waiting;
  return record;
}

void BatchFolder::write_record(StudyRun const& run, RunRecord const& record) const {
  Json const json{{"run", run.id},
                  {"case", record.hash},
                  {"state", word(record.state)},
                  {"exit_status", record.exit_status},
                  {"reason", record.reason},
                  {"attempts", record.attempts},
                  {"cpu_seconds", record.cpu_seconds},
                  {"wall_seconds", record.wall_seconds}};
  write_file(path_ / "states" / (run.id + ".json"),
             json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

FileLock BatchFolder::try_lock(std::string const& id) const {
  return open_lock(path_ / "locks" / (id + ".lock"), LOCK_EX | LOCK_NB);
}

bool BatchFolder::is_locked(std::string const& id) const {
  auto const file = path_ / "locks" / (id + ".lock");
  return fs::exists(file) && !static_cast<bool>(open_lock(file, LOCK_SH | LOCK_NB));
}

} // namespace coupling::study
