#include "continuum/verification/problems.hpp"
#include "coupling/elastic/session.hpp"
#include "coupling/verification/benchmarks.hpp"

#include <algorithm>
#include <cctype>

namespace coupling::verification {
namespace {

using Problem = continuum::verification::Checks (*)();

/// "von Mises stress at the bore [Pa]" -> "von_Mises_stress_at_the_bore": rows are in SI anyway.
std::string row_part(std::string_view words) {
  std::string part;
  for (char const c : words.substr(0, words.find(" ["))) {
    bool const is_kept = std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    if (is_kept)
      part += c;
    else if (!part.empty() && part.back() != '_')
      part += '_';
  }
  return part;
}

std::string_view subject_of(std::string_view check) {
  return check.substr(0, check.find(": "));
}

/// The checks are called "subject: quantity [unit]"; a subject that all rows share is the
/// experiment's and not said again.
std::vector<Benchmark> run(std::string const& name, Problem problem) {
  ensure_session();
  auto const checks = problem();
  bool const is_shared = std::ranges::all_of(checks, [&](auto const& check) {
    return subject_of(check.name) == subject_of(checks.front().name);
  });
  std::vector<Benchmark> rows;
  for (auto const& check : checks) {
    std::string_view const words = check.name;
    std::size_t const start = is_shared ? subject_of(words).size() + 2 : 0;
    rows.push_back(compare(name + "/" + row_part(words.substr(start)), check.reference,
                           check.result, check.tolerance, check.source));
  }
  return rows;
}

} // namespace

std::vector<Experiment> elasticity_experiments() {
  using namespace continuum::verification;
  std::vector<Experiment> all;
  for (auto const& [name, problem] :
       {std::pair<std::string, Problem>{"tube_in_plane_strain", check_tube_in_plane_strain},
        {"tube_with_free_ends", check_tube_with_free_ends},
        {"thick_elliptic_plate", check_thick_elliptic_plate},
        {"manufactured_solution", check_manufactured_solution},
        {"beams", check_beams},
        {"discs", check_discs},
        {"pressed_block", check_hertz_pressure}, // "hertz" filters collisions of grains
        {"column", check_column}}) {
    std::string const path = "elasticity/" + name;
    all.push_back({path, [path, problem = problem] { return run(path, problem); }});
  }
  return all;
}

} // namespace coupling::verification
