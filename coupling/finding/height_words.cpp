#include "coupling/finding/height_words.hpp"

#include "coupling/diagnosis/model.hpp"
#include "dem/vec3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace coupling::finding {
namespace {

using reduced::Asked;
using reduced::HeightRow;
using reduced::PressedHeight;

constexpr double mm = 1e-3, kN = 1e3, um = 1e-6, normal_95 = 1.96;

/// Solid in a compact of the grains' density `density`: height without voids [m] at the bore.
double solid_height(PressedHeight const& model, double density) {
  auto const& known = model.known();
  return known.nominal.solid_density / density * known.nominal.pressed.bed.solid_area;
}

/// Height of a compact in the die that measures so after a springback s.
double in_die(PressedHeight const& model, HeightRow const& row, double measured, double density,
              double s) {
  if (row.asked == Asked::compact_height)
    return measured / (1.0 + s);
  double const wider = 1.0 + model.known().springback.radial_share * s;
  return solid_height(model, density) / (1.0 - measured) / (wider * wider) / (1.0 + s);
}

double own_stretch(PressedHeight const& model, HeightRow const& row) {
  auto const& machine = model.known().nominal.machine;
  return machine.frame.gap_offset +
         (machine.gap_is_of_faces ? 0.0 : machine.frame.deflection(row.force));
}

std::string springback_sentence(PressedHeight const& model, HeightRow const& row,
                                MissingApproach const& missing) {
  auto const& spring = model.known().springback;
  return fmt::format("at {:.1f} kN the machine takes the punches to be {:.2f} mm apart, and the "
                     "compact is {:.2f} mm high: it would have sprung back by {:.0f} %, where "
                     "pressed powder gives back {:.0f} to {:.0f} %",
                     row.force / kN, missing.gap / mm, missing.height / mm,
                     100.0 * (missing.height / (missing.gap + own_stretch(model, row)) - 1.0),
                     100.0 * std::max(spring.mean - 2.0 * spring.sd, 0.0),
                     100.0 * (spring.mean + 2.0 * spring.sd));
}

std::string density_sentence(PressedHeight const& model, MissingApproach const& missing) {
  auto const& density = model.known().solid_density;
  double const sds = (missing.sole_density - density.value) / density.sd;
  double const reach = std::sqrt(3.0) * density.sd;
  auto const range =
      fmt::format("{:.2f} mm at {:.0f} kg/m^3, {:.2f} mm at {:.0f} kg/m^3", missing.most / mm,
                  density.value - reach, missing.least / mm, density.value + reach);
  return std::abs(sds) > 3.0
             ? fmt::format("the density of the grains, with which the porosity was computed, says "
                           "how much is missing ({}), but not whether: alone it would have to be "
                           "{:.0f} kg/m^3, where {:.0f} +- {:.0f} is stated",
                           range, missing.sole_density, density.value, density.sd)
             : fmt::format("the density of the grains, with which the porosity was computed, could "
                           "do it alone if it were {:.0f} kg/m^3 ({})",
                           missing.sole_density, range);
}

std::string same_force_sentence(HeightRow const& row, MissingApproach const& missing) {
  return fmt::format("a frame that gives {:.0f} um/kN ({:.0f} kN/mm) and a gap whose zero is "
                     "{:.2f} mm off do the same at a single force; at half the force the frame "
                     "gives half, and the zero stays",
                     missing.value / row.force * kN / um, row.force / missing.value / kN * mm,
                     missing.value / mm);
}

} // namespace

MissingApproach missing_approach(PressedHeight const& model, std::size_t row_number,
                                 double measured, double sd) {
  auto const& row = model.rows()[row_number];
  auto const& known = model.known();
  auto const& density = known.solid_density;
  double const s = known.springback.mean;
  double const told = row.gap + own_stretch(model, row);
  auto const missing = [&](double value, double rho, double springback) {
    return in_die(model, row, value, rho, springback) - told;
  };
  double const value = missing(measured, density.value, s);
  double const by_spring = missing(measured, density.value, s + known.springback.sd) - value;
  double const by_density = missing(measured, density.value + density.sd, s) - value;
  double const by_reading = missing(measured + sd, density.value, s) - value;
  bool const has_density = row.asked == Asked::porosity;
  double const by_mass = has_density ? known.mass_sd * (value + told) : 0.0;
  double const reach = std::sqrt(3.0) * density.sd;
  return {.gap = row.gap,
          .height =
              has_density ? in_die(model, row, measured, density.value, s) * (1.0 + s) : measured,
          .value = value,
          .sd = std::hypot(std::hypot(by_spring, by_density, by_reading), by_mass, known.gap_sd),
          .least = missing(measured, density.value + reach, s),
          .most = missing(measured, density.value - reach, s),
          .sole_density = has_density ? density.value * (value + told) / told : 0.0};
}

std::vector<std::string> height_sentences(PressedHeight const& model,
                                          reduced::HeightRows const& rows, bool is_contradiction) {
  std::vector<std::string> sentences;
  std::vector<double> forces;
  for (std::size_t k = 0; k < rows.rows.size(); ++k) {
    auto const& row = rows.rows[k];
    auto const& block = rows.blocks[k];
    double const sd =
        std::ranges::find(rows.channels, block.channel, &diagnosis::ChannelError::channel)->sd;
    auto const missing = missing_approach(model, k, block.values[0], sd);
    auto const where = block.run + ": ";
    auto const size = fmt::format("{:.2f} mm ({:.2f} to {:.2f} with 95 %)", missing.value / mm,
                                  (missing.value - normal_95 * missing.sd) / mm,
                                  (missing.value + normal_95 * missing.sd) / mm);
    if (!is_contradiction) {
      sentences.push_back(where + "gap and compact fit each other; of the approach is missing " +
                          size);
      continue;
    }
    sentences.push_back(where + springback_sentence(model, row, missing));
    sentences.push_back(where + size +
                        " of the approach is missing: the punch faces stood so much further apart "
                        "than the machine took them to be");
    if (missing.sole_density > 0.0)
      sentences.push_back(where + density_sentence(model, missing));
    if (std::ranges::find(forces, row.force) == forces.end())
      forces.push_back(row.force);
    if (k + 1 == rows.rows.size() && forces.size() == 1 && missing.value > 0.0)
      sentences.push_back(where + same_force_sentence(row, missing));
  }
  return sentences;
}

} // namespace coupling::finding
