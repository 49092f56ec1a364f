#include "coupling/finding/bed_facts.hpp"

#include "coupling/case_file.hpp"
#include "coupling/record/curves.hpp"
#include "coupling/record/run_file.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace coupling::finding {

BedFacts bed_facts(std::filesystem::path const& run_folder) {
  auto const record = read_curves(run_folder / "curves.csv");
  auto const force = record.column("upper_punch_force"), time = record.column("time");
  auto const peak = static_cast<std::size_t>(std::ranges::max_element(force) - force.begin());
  auto before = peak;
  while (before > 0 && force[before] > 0.8 * force[peak])
    --before;
  double const bore = read_case(run_folder / "case.resolved.prm").tooling.bore_diameter;
  BedFacts facts{.largest_stress = force[peak] / (0.25 * std::numbers::pi * bore * bore)};
  if (force[before] < force[peak])
    facts.growth_time = force[peak] * (time[peak] - time[before]) / (force[peak] - force[before]);
  if (auto const file = run_folder / "run.h5";
      std::filesystem::exists(file) && record.has("mean_overlap")) {
    auto const& radius = read_grains(file).radius;
    double const mean =
        std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(radius.size());
    facts.relative_overlap = record.column("mean_overlap")[peak] / (0.5 * mean);
  }
  return facts;
}

} // namespace coupling::finding
