#include "tests/diagnosis/grains/simulations.hpp"

#include "tests/diagnosis/grains/peer.hpp"
#include "tests/diagnosis/hide/press.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hidden {
namespace {

namespace fs = std::filesystem;

std::string text_of(fs::path const& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write(fs::path const& file, std::string const& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
    throw std::runtime_error(
        fmt::format("{}: cannot be written. Is the disk full?", file.string()));
}

std::string quoted(std::string const& word) {
  std::string text = "'";
  for (char const c : word)
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Runs a shell's command with its output in `log`.
void run(std::string const& command, fs::path const& log) {
  if (std::system(fmt::format("{} >{} 2>&1", command, quoted(log.string())).c_str()) == 0)
    return;
  std::istringstream lines(text_of(log));
  std::string last;
  for (std::string line; std::getline(lines, line);)
    last = line.empty() ? last : line;
  throw std::runtime_error(
      fmt::format("{}: {} (a simulation failed). Does it run alone?", log.string(), last));
}

void run_own(Simulations const& with, fs::path const& folder,
             std::vector<std::string> const& entries) {
  std::string command =
      fmt::format("OMP_NUM_THREADS=1 {} run {} --threads 1 --quiet --force -o {}",
                  quoted(with.program), quoted(with.own_case), quoted(folder.string()));
  for (auto const& entry : entries)
    command += " --set " + quoted(entry);
  run(command, folder.string() + ".log");
}

void run_peer(Simulations const& with, fs::path const& folder, GrainPress const& press) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (auto const& [name, text] : deck_of(press))
    write(folder / name, text);
  run(fmt::format("cd {} && OMP_NUM_THREADS=1 {} -in in.press", quoted(folder.string()),
                  quoted(with.program)),
      folder.string() + ".log");
}

/// Held while a folder is made, so that cases which need the same simulation run it once.
class Lock {
public:
  explicit Lock(fs::path const& file)
      : file_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (file_ < 0 || flock(file_, LOCK_EX) != 0)
      throw std::runtime_error(
          fmt::format("{}: cannot be locked. Is the folder writable?", file.string()));
  }
  Lock(Lock const&) = delete;
  Lock& operator=(Lock const&) = delete;
  ~Lock() { close(file_); }

private:
  int file_;
};

} // namespace

std::vector<std::string> entries_of(GrainPress const& press) {
  auto entries = std::vector<std::string>{
      "Mode=rigid",
      "Output/Snapshot interval=0 s",
      fmt::format("Press programme/Stage 1/Gap={:.6g} m", press.end_gap),
      "Press programme/Stage 2/Gap=0.0125 m",     // the punch has long left the compact
      "Press programme/Stage 4/Duration=0.002 s", // in which its height comes to rest
      fmt::format("Powder/Packing seed={}", press.packing),
      fmt::format("Powder/Component 1/Young's modulus={:.6g} Pa", press.young_modulus),
      fmt::format("Powder/Component 2/Young's modulus={:.6g} Pa", press.young_modulus),
      fmt::format("Contact/Particle-particle/Cohesion energy density={:.6g} J/m^3",
                  press.cohesion_density)};
  if (press.friction != 0.2)
    entries.push_back(fmt::format("Contact/Particle-particle/Coefficient of static friction={:.6g}",
                                  press.friction));
  if (press.wall_friction != 0.2)
    entries.push_back(fmt::format("Contact/Particle-wall/Coefficient of static friction={:.6g}",
                                  press.wall_friction));
  entries.insert(entries.end(), press.more.begin(), press.more.end());
  return entries;
}

Curve Simulations::curve(GrainPress const& press, std::string const& change) const {
  auto const folder =
      cache / fmt::format("packing-{}{}{}", press.packing, change.empty() ? "" : "-", change);
  auto const text = fmt::format("{}\n", fmt::join(entries_of(press), "\n"));
  fs::create_directories(cache);
  Lock const lock(folder.string() + ".lock");
  if (text_of(folder / "entries.txt") != text) {
    if (code == Code::own)
      run_own(*this, folder, entries_of(press));
    else
      run_peer(*this, folder, press);
    write(folder / "entries.txt", text); // last: a folder with it is complete
  }
  return code == Code::own ? read_run(folder) : read_peer(folder / "curves.txt", stated_bore);
}

} // namespace hidden
