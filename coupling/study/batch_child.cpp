#include "coupling/study/batch_child.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace coupling::study {
namespace {

/// The environment without what a launcher of MPI left for its ranks: a run is no rank, and must
/// not take itself for one when its elastic tools start MPI.
std::vector<char*> environment_of_child() {
  constexpr std::array<std::string_view, 8> of_launchers{
      "OMPI_", "PMI_", "PMI2_", "PMIX_", "PRTE_", "HYDRA_", "MPIEXEC_", "MPI_LOCAL"};
  std::vector<char*> kept;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    std::string_view const text = *variable;
    bool drop = false;
    for (auto const head : of_launchers)
      drop = drop || text.starts_with(head);
    if (!drop)
      kept.push_back(*variable);
  }
  kept.push_back(nullptr);
  return kept;
}

double seconds(timeval const& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Between fork and exec: only what a signal handler might do.
[[noreturn]] void become(char* const* arguments, char* const* environment, char const* log,
                         int lock, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) // it died before it could be waited for
    _exit(128 + SIGKILL);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  fcntl(lock, F_SETFD, 0); // the one descriptor that outlives exec
  int const out = open(log, O_WRONLY | O_CREAT | O_APPEND, 0666);
  int const in = open("/dev/null", O_RDONLY);
  if (out >= 0) {
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    close(out);
  }
  if (in >= 0) {
    dup2(in, STDIN_FILENO);
    close(in);
  }
  execve("/proc/self/exe", arguments, environment);
  _exit(127);
}

/// The end of a file, enough for a few lines.
std::string tail_of(std::filesystem::path const& file) {
  constexpr std::streamoff enough = 8192;
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(0, std::ios::end);
  auto const size = static_cast<std::streamoff>(stream.tellg());
  if (size <= 0)
    return {};
  stream.seekg(std::max<std::streamoff>(0, size - enough));
  return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

BatchChild::BatchChild(StudyRun const& run, FileLock lock,
                       std::vector<std::string> const& arguments, std::filesystem::path const& log)
    : run_(&run), lock_(std::move(lock)) {
  std::vector<std::string> words{"presscheck"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (auto& one : words)
    pointers.push_back(one.data());
  pointers.push_back(nullptr);
  auto const environment = environment_of_child();
  pid_t const parent = getpid();
  process_ = fork();
  if (process_ == 0)
    become(pointers.data(), environment.data(), log.c_str(), lock_.descriptor(), parent);
  if (process_ < 0)
    throw std::runtime_error("study: no further process can be started (" +
                             std::string(std::strerror(errno)) + "). Fewer --jobs?");
}

std::optional<BatchChild::End> BatchChild::poll() {
  int status = 0;
  rusage used{};
  pid_t const ended = wait4(process_, &status, WNOHANG, &used);
  if (ended == 0 || (ended < 0 && errno == EINTR))
    return std::nullopt;
  auto const wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  return End{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
             seconds(used.ru_utime) + seconds(used.ru_stime), wall};
}

void BatchChild::signal(int number) const {
  kill(process_, number);
}

std::string last_line(std::filesystem::path const& log) {
  std::string text = tail_of(log);
  auto const end = text.find_last_not_of("\r\n\t ");
  if (end == std::string::npos)
    return {};
  text.resize(end + 1);
  return text.substr(text.find_last_of('\n') + 1);
}

double logged_fraction(std::filesystem::path const& log) {
  auto const text = tail_of(log);
  auto const mark = text.rfind(" %  t = ");
  auto const line = text.find_last_of('\n', mark);
  auto const first = text.find_first_not_of(' ', line == std::string::npos ? 0 : line + 1);
  double percent = 0.0;
  if (mark != std::string::npos && first != std::string::npos)
    std::from_chars(text.data() + first, text.data() + text.size(), percent);
  return 0.01 * percent;
}

} // namespace coupling::study
