#include "coupling/verification/benchmarks.hpp"
#include "coupling/verification/closed_forms.hpp"
#include "coupling/verification/setups.hpp"

#include <cmath>
#include <functional>
#include <utility>

namespace coupling::verification {
namespace {

struct Convention {
  char const* name;
  double factor; ///< C of A = C R* d
};

Recipe cohesive(char const* law) {
  Recipe recipe;
  recipe.law.cohesion = law;
  recipe.law.precision = dem::Precision::full;
  recipe.grain_grain.cohesion_energy_density = 5e6;
  return recipe;
}

/// Normal force [N] on the upper of two equal grains at rest, at this overlap.
double resting_force(Recipe const& recipe, double radius, double overlap) {
  dem::World world = empty_world(recipe);
  world.grains.add(dem::Vec3(0, 0, 2.0 * radius - overlap), radius, recipe.grain.density, 0);
  world.grains.add(dem::Vec3::Zero(), radius, recipe.grain.density, 0);
  dem::prepare(world);
  return world.grains.force[row_of(world, 0)].z();
}

/// Where `f` changes sign between a and b.
double bisect(std::function<double(double)> const& f, double a, double b) {
  bool const rises = f(a) < 0.0;
  for (int k = 0; k < 60; ++k) {
    double const middle = 0.5 * (a + b);
    ((f(middle) < 0.0) == rises ? a : b) = middle;
  }
  return 0.5 * (a + b);
}

/// Place of the smallest value of `f` between a and b, by golden section.
double lowest(std::function<double(double)> const& f, double a, double b) {
  double const golden = 0.5 * (std::sqrt(5.0) - 1.0);
  for (int k = 0; k < 60; ++k) {
    double const left = b - golden * (b - a), right = a + golden * (b - a);
    (f(left) < f(right) ? b : a) = f(left) < f(right) ? right : left;
  }
  return 0.5 * (a + b);
}

/// Zero-force overlap and deepest tension of Hertz with each linear cohesion, two grains of 0.5 mm.
std::vector<Benchmark> linear(Convention const& convention) {
  Recipe const recipe = cohesive(convention.name);
  double const R = 0.25e-3, E = recipe.grain.young_modulus, nu = recipe.grain.poisson_ratio;
  LinearCohesion const exact{.stiffness =
                                 4.0 / 3.0 * effective_modulus(E, nu, E, nu) * std::sqrt(R / 2.0),
                             .slope = convention.factor * R / 2.0 * 5e6};
  auto const force = [&](double overlap) { return resting_force(recipe, R, overlap); };
  double const d0 = exact.zero_force_overlap();
  double const deepest = lowest(force, 0.05 * d0, 0.95 * d0);
  std::string const name = std::string("cohesion/") + convention.name;
  char const* const source = "K d^(3/2) = c d: d0 = (c/K)^2; F_min = -4/27 c^3/K^2 at 4/9 d0";
  std::vector<Benchmark> rows{
      compare(name + "/zero_force_overlap", d0, bisect(force, 0.5 * d0, 2.0 * d0), 1e-10, source),
      compare(name + "/deepest_tension", exact.deepest_force(), force(deepest), 1e-10, source),
      // A minimum is flat: its place is known to the root of the rounding of its value.
      compare(name + "/deepest_overlap", exact.deepest_overlap(), deepest, 1e-6, source)};
  if (std::string(convention.name) == "sjkr2") {
    rows.push_back(compare(name + "/liggghts_pair_at_rest", 1.561402e-5,
                           bisect(force, 0.5 * d0, 2.0 * d0), 1e-6,
                           "LIGGGHTS 3.8.0, pair settled at rest"));
  }
  return rows;
}

/// Two grains so heavy that they keep their speed are drawn apart: the force over the overlap.
std::vector<std::pair<double, double>> draw_apart(Recipe const& recipe, double radius, double speed,
                                                  double from, double to, int steps) {
  double const heavy = 1e15; // [kg/m^3]
  dem::World world = empty_world(recipe);
  dem::Vec3 const apart(0, 0, 0.5 * speed);
  world.grains.add(dem::Vec3(0, 0, 2.0 * radius - from), radius, heavy, 0, apart);
  world.grains.add(dem::Vec3::Zero(), radius, heavy, 0, -apart);
  dem::prepare(world);
  double const dt = (from - to) / speed / steps;
  std::vector<std::pair<double, double>> curve;
  for (int k = 0; k < steps; ++k) {
    dem::advance(world, dt);
    std::size_t const i = row_of(world, 0), j = row_of(world, 1);
    double const distance = (world.grains.position[i] - world.grains.position[j]).norm();
    curve.emplace_back(2.0 * radius - distance, world.grains.force[i].z());
  }
  return curve;
}

std::vector<Benchmark> jkr() {
  Recipe recipe = smooth();
  recipe.law.normal = "jkr";
  recipe.grain_grain.surface_energy = 5.0;
  double const R = 0.25e-3, E = recipe.grain.young_modulus, nu = recipe.grain.poisson_ratio;
  Adhesion const exact{.effective_modulus = effective_modulus(E, nu, E, nu),
                       .effective_radius = R / 2.0,
                       .work = 5.0};
  double const d0 = exact.zero_load_overlap();
  int const steps = 40000;
  auto const curve = draw_apart(recipe, R, 1e-3, 3.0 * d0, -3.0 * d0, steps);

  double pull_off = 0.0, zero = 0.0, last_overlap = 3.0 * d0, last_force = 0.0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    auto const [overlap, force] = curve[k];
    pull_off = std::min(pull_off, force);
    if (k > 0 && curve[k - 1].second > 0.0 && force <= 0.0) {
      double const share = force / (force - curve[k - 1].second);
      zero = overlap + share * (curve[k - 1].first - overlap);
    }
    if (force != 0.0) {
      last_overlap = overlap;
      last_force = force;
    }
  }
  char const* const source = "Johnson, Kendall and Roberts, Proc. R. Soc. A 324 (1971) 301";
  // One step is 1.5e-4 of d0; the branch ends with an infinite slope, so its last force is known to
  // the root of that.
  return {compare("jkr/pull_off_force", exact.pull_off_force(), pull_off, 1e-6, source),
          compare("jkr/zero_load_overlap", d0, zero, 1e-5, source),
          compare("jkr/separation_overlap", exact.separation_overlap(), last_overlap, 5e-4, source),
          compare("jkr/separation_force", exact.separation_force(), last_force, 2e-2, source)};
}

} // namespace

std::vector<Experiment> adhesion_experiments() {
  std::vector<Experiment> all;
  for (Convention const& convention :
       {Convention{"sjkr2", 4.0 * pi}, Convention{"linear_reduced", 2.0 * pi},
        Convention{"linear_hertz_circle", pi}}) {
    all.push_back(
        {std::string("cohesion/") + convention.name, [convention] { return linear(convention); }});
  }
  all.push_back({"jkr", jkr});
  return all;
}

} // namespace coupling::verification
