#include "continuum/session.hpp"
#include "continuum/tool/interface_compliance.hpp"

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <span>
#include <string>
#include <thread>

/// [mpirun -n N] shared_tool die|punch CELL_SIZE [FILE]
///   Solves the seed press's die or punch of cells about CELL_SIZE [m] wide under forces that
///   belong to no symmetry, and condenses it, over N ranks. FILE gets what came out, as doubles;
///   standard output the time of each step and the CPU time and peak memory of each rank.
/// [mpirun -n N] shared_tool starve MIB
///   The same with a die, each rank but the first allowed MIB more of memory than it has.
/// [mpirun -n N] shared_tool idle SECONDS
///   The first rank sleeps.
namespace {
using namespace continuum;
using Arguments = std::span<char* const>;

double cpu_seconds() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

class Stopwatch {
public:
  void print(char const* step) {
    auto const now = std::chrono::steady_clock::now();
    double const busy = cpu_seconds();
    std::printf("%-10s %8.2f s, CPU of the first rank %8.2f s\n", step,
                std::chrono::duration<double>(now - since_).count(), busy - busy_since_);
    since_ = now;
    busy_since_ = busy;
  }

private:
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
  double busy_since_ = cpu_seconds();
};

void print_use(char const* rank) {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  std::printf("%s rank: CPU %.2f s, peak %ld MiB\n", rank, cpu_seconds(), use.ru_maxrss / 1024);
}

ElasticTool make_tool(bool is_die, double cell_size) {
  constexpr ElasticMaterial steel{.young_modulus = 210e9, .poisson_ratio = 0.3};
  DieShape const die{.bore_radius = 11.025e-3, .outer_radius = 30e-3, .height = 30e-3};
  PunchShape const punch{.radius = 11.025e-3, .length = 20e-3};
  if (is_die)
    return {
        ToolMesh::die(die, cells_of_size(die, cell_size)), {steel}, Supports::clamped("bottom")};
  return {
      ToolMesh::punch(punch, cells_of_size(punch, cell_size)), {steel}, Supports::clamped("back")};
}

// Pressure, and on every third node a force aside.
Eigen::Matrix3Xd forces_on(SurfaceTrace const& trace) {
  Eigen::Matrix3Xd forces = trace.pressure_loads(65.7e6);
  for (Eigen::Index a = 0; a < forces.cols(); a += 3)
    forces.col(a) += Eigen::Vector3d(20.0, -7.0, 3.0);
  return forces;
}

void put(std::ofstream& file, Eigen::MatrixXd const& values) {
  file.write(reinterpret_cast<char const*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(double)));
}

void calculate(std::string const& name, double cell_size, char const* file_name) {
  std::string const surface = name == "punch" ? "face" : "bore";
  Stopwatch watch;
  ElasticTool const tool = make_tool(name != "punch", cell_size);
  watch.print("factorise");
  SurfaceTrace const trace = tool.mesh().trace(surface);
  auto const solution = tool.solve(tool.spread(trace, forces_on(trace)));
  watch.print("solve");
  auto const compliance = InterfaceCompliance::condense(tool, surface);
  watch.print("condense");
  std::printf("%zu unknowns, %td on the surface, residual %.1e\n", 3 * tool.mesh().n_nodes(),
              compliance.matrix().rows(), solution.residual);
  if (file_name == nullptr)
    return;
  std::ofstream file(file_name, std::ios::binary);
  put(file, solution.displacement);
  for (StressPoint const& point : tool.stress_on(surface, solution.displacement))
    put(file, point.stress);
  put(file, compliance.matrix());
}

void allow_more_memory(double mebibytes) {
  std::ifstream statm("/proc/self/statm");
  double pages = 0.0;
  statm >> pages;
  auto const limit = static_cast<rlim_t>(4096.0 * pages + mebibytes * 1048576.0);
  rlimit const both{.rlim_cur = limit, .rlim_max = limit};
  setrlimit(RLIMIT_AS, &both);
}

void help(Arguments words) {
  if (std::string(words[1]) == "starve")
    allow_more_memory(std::stod(words[2]));
  Session::help();
  print_use("another");
}

void lead(Arguments words) {
  double const number = std::stod(words[2]);
  std::string const what = words[1];
  if (what == "idle")
    std::this_thread::sleep_for(std::chrono::duration<double>(number));
  else
    calculate(what, what == "starve" ? 3.5e-3 : number, words.size() > 3 ? words[3] : nullptr);
  print_use("first");
}
} // namespace

int main(int argc, char** argv) {
  Session const session;
  try {
    (Session::is_helper() ? help : lead)({argv, static_cast<std::size_t>(argc)});
    return 0;
  } catch (std::exception const& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
