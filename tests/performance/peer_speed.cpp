#include "tests/crosscode/liggghts/bed.hpp"
#include "tests/crosscode/liggghts/child_process.hpp"
#include "tests/crosscode/liggghts/deck.hpp"
#include "tests/crosscode/liggghts/text_file.hpp"
#include "tests/performance/dense_press.hpp"
#include "tests/performance/speed_table.hpp"

#include "dem/packing/packing_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <sstream>

/// peer_speed [ROUNDS [PACKING GAP]]
/// Our steps against LIGGGHTS' on one dense bed, alternating, per CPU second and thread; two
/// threads against one; the share of list builds and of output; memory. Every cost of a step is
/// that of a long run less that of a short one, so that starting up cancels. ROUNDS = 0: only the
/// shares and the memory. Exit status 1 if a bar is missed. Run it on an idle machine: two threads
/// that share their cores with other programs wait for each other at every step.
namespace performance {
namespace {

using crosscode::ProcessCost;

// The first steps after reading a packing are not those of a dense bed: without its tangential
// springs it flinches.
constexpr long n_short = 800, n_long = 2400;

struct Bench {
  std::filesystem::path folder;
  DenseBed bed;
  dem::Packing packing;
  double dt; ///< [s]
};

ProcessCost difference(ProcessCost const& longer, ProcessCost const& shorter) {
  double const n_steps = n_long - n_short;
  return {.exit_status = 0,
          .cpu_seconds = (longer.cpu_seconds - shorter.cpu_seconds) / n_steps,
          .wall_seconds = (longer.wall_seconds - shorter.wall_seconds) / n_steps,
          .largest_memory = longer.largest_memory};
}

ProcessCost run_peer(Bench const& bench, long n_steps) {
  auto const folder = bench.folder / "liggghts";
  crosscode::PressDeck const deck{.bore_diameter = bench.bed.bore_diameter,
                                  .start_gap = bench.bed.gap,
                                  .record_every = 1'000'000,
                                  .moves = {{.speed = 0.0, .n_steps = n_steps, .dt = bench.dt}}};
  write_press_deck(deck, bench.packing, folder);
  auto const cost = crosscode::run_program(
      {crosscode::find_program("liggghts", "liggghts"), "-in", "in.press"}, folder);
  if (cost.exit_status != 0)
    throw std::runtime_error("liggghts failed, see " + folder.string());
  return cost;
}

ProcessCost run_ours(Bench const& bench, std::string const& precision, long n_steps, int threads,
                     std::filesystem::path const& packing) {
  auto const cost =
      crosscode::run_program({STEP_DENSE_PROGRAM, std::filesystem::absolute(packing).string(),
                              fmt::format("{}", bench.bed.bore_diameter),
                              fmt::format("{}", bench.bed.gap), precision, std::to_string(n_steps)},
                             bench.folder, threads);
  if (cost.exit_status != 0)
    throw std::runtime_error(crosscode::read_text(bench.folder / "output.txt"));
  return cost;
}

ProcessCost our_step(Bench const& bench, std::string const& precision, int threads) {
  auto const shorter = run_ours(bench, precision, n_short, threads, bench.bed.packing_file);
  return difference(run_ours(bench, precision, n_long, threads, bench.bed.packing_file), shorter);
}

/// Share of list builds in the wall time of the last run of ours [1].
double list_share(Bench const& bench) {
  std::istringstream words(crosscode::read_text(bench.folder / "output.txt"));
  double wall = 0.0, in_builds = 0.0;
  words >> wall >> in_builds;
  return in_builds / wall;
}

/// Part of a run's CPU time that curves, pictures and measures at their default intervals take [1],
/// while the bed stands for 5 ms.
double output_share(Bench const& bench) {
  auto const run = [&](std::vector<std::string> const& entries) {
    crosscode::write_text(bench.folder / "hold.prm", "set Title = Dense bed\n");
    std::vector<std::string> command{PRESSCHECK_PROGRAM, "run",    "hold.prm", "-o", "hold",
                                     "--force",          "--quiet"};
    for (std::string const& entry : entries)
      command.insert(command.end(), {"--set", entry});
    for (std::string const& entry :
         {std::string("Powder/Fill method=file"),
          "Powder/Fill file=" + std::filesystem::absolute(bench.bed.packing_file).string(),
          fmt::format("Powder/Fill height={} m", bench.bed.gap),
          std::string("Tooling/Walls=analytic"), std::string("Press programme/Stage 1/Kind=free"),
          std::string("Press programme/Stage 1/Duration=5 ms"),
          std::string("Press programme/Stage 2/Kind=none"),
          std::string("Press programme/Stage 3/Kind=none"),
          std::string("Press programme/Stage 4/Kind=none")})
      command.insert(command.end(), {"--set", entry});
    auto const cost = crosscode::run_program(command, bench.folder);
    if (cost.exit_status != 0)
      throw std::runtime_error(crosscode::read_text(bench.folder / "output.txt"));
    return cost.cpu_seconds;
  };
  double const without = run({"Output/Record interval=1 s", "Output/Snapshot interval=0 s"});
  return (run({}) - without) / without;
}

/// Peak memory per grain [bytes]: of the whole bed less that of a few grains of it.
double bytes_per_grain(Bench const& bench, std::string const& precision) {
  auto const few_file = bench.folder / "few.csv";
  dem::Packing const few(bench.packing.end() - 200, bench.packing.end());
  dem::write_packing(few_file, few, crosscode::seed_components());
  double const all = run_ours(bench, precision, 10, 1, bench.bed.packing_file).largest_memory;
  return (all - run_ours(bench, precision, 10, 1, few_file).largest_memory) /
         static_cast<double>(bench.packing.size() - few.size());
}

bool compare_with_peer(Bench const& bench, int rounds) {
  Samples peer, full, mixed, full_ratio, mixed_ratio, full_threads, mixed_threads;
  for (int round = 0; round < rounds; ++round) {
    auto const peer_short = run_peer(bench, n_short);
    peer.push_back(1e3 * difference(run_peer(bench, n_long), peer_short).cpu_seconds);
    ProcessCost const one_full = our_step(bench, "double", 1),
                      one_mixed = our_step(bench, "mixed", 1);
    full.push_back(1e3 * one_full.cpu_seconds);
    mixed.push_back(1e3 * one_mixed.cpu_seconds);
    full_ratio.push_back(peer.back() / full.back());
    mixed_ratio.push_back(peer.back() / mixed.back());
    full_threads.push_back(one_full.wall_seconds / our_step(bench, "double", 2).wall_seconds);
    mixed_threads.push_back(one_mixed.wall_seconds / our_step(bench, "mixed", 2).wall_seconds);
    fmt::print("round {}: load {}\n", round + 1,
               crosscode::read_text("/proc/loadavg").substr(0, 4));
    std::fflush(stdout);
  }
  print_row("LIGGGHTS, double", "CPU ms per step", peer);
  print_row("presscheck, double", "CPU ms per step", full);
  print_row("presscheck, mixed", "CPU ms per step", mixed);
  bool const ok[] = {
      print_row("LIGGGHTS / presscheck, double", "per CPU second", full_ratio, at_least(3.5)),
      print_row("LIGGGHTS / presscheck, mixed", "per CPU second", mixed_ratio, at_least(6.0)),
      print_row("two threads / one, double", "wall time", full_threads, at_least(1.7)),
      print_row("two threads / one, mixed", "wall time", mixed_threads, at_least(1.7))};
  return std::ranges::all_of(ok, std::identity{});
}

bool measure_overheads(Bench const& bench) {
  bool all_ok = true;
  for (std::string const precision : {"double", "mixed"}) {
    run_ours(bench, precision, n_long, 1, bench.bed.packing_file);
    all_ok &=
        print_row("list builds, " + precision, "share of time", {list_share(bench)}, at_most(0.1));
    all_ok &= print_row("memory, " + precision, "bytes per grain",
                        {bytes_per_grain(bench, precision)}, at_most(1000.0));
  }
  all_ok &= print_row("records and pictures", "share of time", {output_share(bench)}, at_most(0.1));
  return all_ok;
}

Bench prepare(int argc, char** argv) {
  Bench bench{.folder = std::filesystem::path(STEP_DENSE_PROGRAM).parent_path() / "peer_speed",
              .bed = {},
              .packing = {},
              .dt = 0.0};
  std::filesystem::create_directories(bench.folder);
  bench.bed.packing_file = argc > 3 ? std::filesystem::path(argv[2]) : bench.folder / "dense.csv";
  if (argc > 3)
    bench.bed.gap = std::stod(argv[3]);
  else if (!std::filesystem::exists(bench.bed.packing_file))
    press_dense_bed(bench.bed);
  bench.packing = dem::read_packing(bench.bed.packing_file, crosscode::seed_components());
  bench.dt = step_of(stand_still(bench.bed, dem::Precision::full));
  return bench;
}

} // namespace
} // namespace performance

int main(int argc, char** argv) {
  try {
    auto const bench = performance::prepare(argc, argv);
    fmt::print("{}, {} grains, Z = {:.2f}, law hertz + mindlin + sjkr2, step {:.4g} s\n"
               "LIGGGHTS: Debian's build (baseline x86-64, contact model not in its optimised "
               "list); steps {} to {}\n",
               performance::processor_name(), bench.packing.size(),
               crosscode::coordination(bench.packing), bench.dt, performance::n_short,
               performance::n_long);
    int const rounds = argc > 1 ? std::stoi(argv[1]) : 5;
    bool const is_fast = rounds <= 0 || performance::compare_with_peer(bench, rounds);
    bool const is_lean = performance::measure_overheads(bench);
    return is_fast && is_lean ? 0 : 1;
  } catch (std::exception const& error) {
    fmt::print(stderr, "peer_speed: {}\n", error.what());
    return 2;
  }
}
