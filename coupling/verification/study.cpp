#include "coupling/study/calibration.hpp"
#include "coupling/study/design.hpp"
#include "coupling/study/packing_model.hpp"
#include "coupling/study/size_trend.hpp"
#include "coupling/verification/benchmarks.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <tuple>

/// The seed's own numbers from its own tables: Ramirez-Aragon et al., Materials 13 (2020) 224.
namespace coupling::verification {
namespace {

using Nine = std::array<double, 9>;

/// A column of table 7, modulus changing slowest, and the coefficients of its equation.
struct PrintedEquation {
  int number;
  char const* response;
  Nine table;
  std::array<double, 6> coefficients; ///< intercept, E, CED, E CED, E^2, CED^2
  double rounding;                    ///< half of the last printed digit
};

constexpr PrintedEquation force_edem{
    1,
    "max_force",
    {15787, 15201, 14506, 29495, 28867, 28155, 43279, 42745, 41846},
    {28900.822, 13729.317, -675.683, -38.1, 54.917, -92.683},
    0.5}; // fitted to unrounded forces; the table has whole newtons
constexpr PrintedEquation force_liggghts{
    4,
    "max_force",
    {15865, 15283, 14662, 29647, 29015, 28369, 43393, 42827, 42172},
    {29026.111, 13763.667, -617, -4.5, 23.333, -23.667},
    0.5e-3};
constexpr std::array equations{
    force_edem,
    PrintedEquation{2,
                    "porosity",
                    {41.48, 39.14, 38.95, 44.93, 41.32, 39.37, 46.08, 43.02, 40.90},
                    {41.34556, 1.73833, -2.21167, -0.6625, -0.27833, 0.79167},
                    0.5e-5},
    PrintedEquation{
        3, "shape_quality", {5, 5, 5, 4, 5, 5, 3, 5, 5}, {5, -0.33333, 0.5, 0.5, 0, -0.5}, 0.5e-5},
    force_liggghts,
    PrintedEquation{5,
                    "porosity",
                    {41.34, 36.20, 35.32, 45.87, 40.51, 37.23, 47.31, 44.14, 39.87},
                    {40.62111, 3.07667, -3.68333, -0.355, -0.50667, 0.87333},
                    0.5e-5},
    PrintedEquation{6,
                    "shape_quality",
                    {3, 5, 5, 2, 4, 5, 2, 2, 4},
                    {3.77778, -0.83333, 1.16667, 0, -0.16667, -0.16667},
                    0.5e-5}};

study::ResponseSurface surface_of(PrintedEquation const& equation) {
  Eigen::VectorXd const y = Eigen::Map<Eigen::VectorXd const>(equation.table.data(), 9);
  return study::fit_response_surface(
      {{"E", "CED"}, study::full_factorial({3, 3}), equation.response, y},
      study::quadratic_terms(2));
}

/// A printed number: within its rounding (a hair more: 5e-6 is no binary number).
Benchmark printed(std::string name, double reference, double result, double rounding,
                  std::string source) {
  double const scale = reference == 0.0 ? 1.0 : std::abs(reference);
  return compare(std::move(name), reference, result, rounding * (1.0 + 1e-6) / scale,
                 std::move(source));
}

std::vector<Benchmark> seed_equations() {
  std::vector<Benchmark> rows;
  for (auto const& equation : equations) {
    auto const coefficients = surface_of(equation).coefficients();
    for (std::size_t j = 0; j < coefficients.size(); ++j)
      rows.push_back(printed(
          fmt::format("study/seed_equations/{}_{}", equation.number, coefficients[j].name),
          equation.coefficients[j], coefficients[j].value, equation.rounding,
          fmt::format("Ramirez-Aragon et al. (2020), equation {} from table 7", equation.number)));
  }
  return rows;
}

std::vector<Benchmark> seed_modulus() {
  study::CalibrationFactor const modulus{{"E", 1375.0, 3625.0}, 1375.0, 3625.0, {}}; // [MPa]
  study::CalibrationFactor const cohesion{{"CED", 3.0, 7.0}, 3.0, 7.0, 7.0};         // [1e6 J/m^3]
  std::vector<Benchmark> rows;
  for (auto const& [simulator, equation, reference] :
       {std::tuple("EDEM", force_edem, 2250.0), std::tuple("LIGGGHTS", force_liggghts, 2230.0)}) {
    auto const roots =
        study::factor_for_target({modulus, cohesion}, {surface_of(equation), 25095.0, 0.0});
    rows.push_back(printed(fmt::format("study/seed_modulus/{}", simulator), reference,
                           roots.at(0).value, 1.0,
                           "Ramirez-Aragon et al. (2020), table 5, for 25 095 N at 7e6 J/m^3"));
  }
  return rows;
}

/// The line through table 8's porosities at the alumina's own size. Half a digit in each of the
/// four moves it by 0.0144 points, and the paper rounds to 0.005.
std::vector<Benchmark> seed_porosity() {
  std::vector<double> const sizes{0.3, 0.25, 0.2, 0.15}; // [mm]
  auto const at = [&](std::vector<double> const& porosity) {
    return study::extrapolate(sizes, porosity, 0.045, {study::linear_form()}).fits[0].value;
  };
  char const* const source = "Ramirez-Aragon et al. (2020), section 3.3, line through table 8";
  return {
      printed("study/seed_porosity/EDEM", 26.56, at({38.90, 37.24, 34.37, 31.57}), 0.0194, source),
      printed("study/seed_porosity/LIGGGHTS", 26.25, at({36.83, 35.19, 33.28, 30.37}), 0.0194,
              source)};
}

/// Two sizes that alone pack to 0.64, pressed (K = 9).
std::vector<Benchmark> packing_model() {
  constexpr double beta = 0.7112;
  std::vector<Benchmark> rows;
  struct Entry {
    double ratio, share, fraction;
  };
  for (auto const& [ratio, share, fraction] :
       {Entry{0.4, 0.30, 0.706}, Entry{0.2, 0.2258, 0.725}, Entry{0.1, 0.30, 0.774},
        Entry{0.05, 0.50, 0.762}, Entry{0.001, 0.2258, 0.798}}) {
    double const packed =
        study::packed_fraction({{1.0, 1.0 - share, beta}, {ratio, share, beta}}, 9.0);
    rows.push_back(printed(fmt::format("study/packing_model/{}_at_{}", ratio, share), fraction,
                           packed, 0.5e-3, "de Larrard (1999), worked out apart from this code"));
  }
  rows.push_back(
      printed("study/packing_model/one_size", 0.64,
              study::packed_fraction({{1.0, 1.0, study::virtual_packing(0.64, 9.0)}}, 9.0), 1e-14,
              "beta K / (1 + K)"));
  return rows;
}

} // namespace

std::vector<Experiment> study_experiments() {
  return {{"study/seed_equations", seed_equations},
          {"study/seed_modulus", seed_modulus},
          {"study/seed_porosity", seed_porosity},
          {"study/packing_model", packing_model}};
}

} // namespace coupling::verification
