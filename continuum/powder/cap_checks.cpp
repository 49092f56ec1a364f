#include "continuum/expect.hpp"
#include "continuum/powder/cap_surfaces.hpp"
#include "continuum/powder/hardening.hpp"
#include "continuum/tool/quote.hpp"

#include <numbers>
#include <vector>

namespace continuum {
namespace {

void validate_tables(DruckerPragerCap const& law, std::string const& name) {
  law.cohesion.validate(name + ", cohesion d", "relative density");
  law.friction_angle.validate(name + ", friction angle", "relative density");
  law.eccentricity.validate(name + ", eccentricity R", "relative density");
  law.hardening.validate(name + ", hardening p_b", "volumetric plastic strain");
  for (auto const* table : {&law.cohesion, &law.friction_angle, &law.eccentricity})
    VALIDATE(table->rows.back().x <= 1.0,
             name + ": a row at relative density = " + quote(table->rows.back().x) +
                 " (the solid has 1). Is it in percent?");
}

void validate_ranges(DruckerPragerCap const& law, std::string const& name) {
  VALIDATE(law.cohesion.smallest() >= 0.0,
           name + ": cohesion d = " + quote(law.cohesion.smallest()) +
               " Pa (the shear line would cut q = 0 in compression). Is its sign turned?");
  VALIDATE(law.friction_angle.smallest() > 0.0 &&
               law.friction_angle.largest() < std::numbers::pi / 2.0,
           name + ": friction angle from " + quote(law.friction_angle.smallest()) + " to " +
               quote(law.friction_angle.largest()) +
               " rad (the shear line rises between 0 and pi/2). Is it in degrees?");
  VALIDATE(law.eccentricity.smallest() > 0.0,
           name + ": eccentricity R = " + quote(law.eccentricity.smallest()) +
               " (the cap is convex only with a positive one). Is it of another model?");
  VALIDATE(law.hardening.rows.size() > 1 && law.hardening.is_ascending(),
           name + ": hardening p_b has one row, or falls (a powder hardens as it densifies). Are "
                  "the rows in order?");
  VALIDATE(law.hardening_reference_density > 0.0 && law.hardening_reference_density < 1.0,
           name +
               ": reference density of the hardening = " + quote(law.hardening_reference_density) +
               " (a relative density is between 0 and 1). Is it in percent?");
  VALIDATE(law.tension_cut_off > 0.0 && law.tension_cut_off <= 1.0,
           name + ": tension cut-off = " + quote(law.tension_cut_off) +
               " of the apex d/tan b (a share in (0, 1]). Is it a stress?");
}

/// Where the surfaces bend is where a table has a row; in between they follow monotonically enough.
std::vector<double> compactions_of_rows(DruckerPragerCap const& law) {
  std::vector<double> result = {0.0};
  double const shift = std::log(law.initial_relative_density);
  for (auto const* table : {&law.cohesion, &law.friction_angle, &law.eccentricity})
    for (auto const& row : table->rows)
      if (row.x > 0.0)
        result.push_back(std::log(row.x) - shift);
  for (auto const& row : law.hardening.rows)
    result.push_back(row.x + std::log(law.hardening_reference_density) - shift);
  std::erase_if(result, [](double compaction) { return compaction < 0.0; });
  return result;
}

void validate_shape(DruckerPragerCap const& law, double compaction, std::string const& name) {
  auto const s = cap_shape(law, compaction);
  std::string const at =
      " at relative density " + quote(law.relative_density({.plastic_compaction = compaction}));
  VALIDATE(law.transition >= 0.0 && law.transition < s.cos_b,
           name + ": transition a = " + quote(law.transition) +
               " is not below cos b = " + quote(s.cos_b) + at +
               " (the arc between shear line and cap would not be convex). "
               "Take 0.03 or less?");
  // Denser, the deck of avicel_ph102 as it was filed has a cap that begins in tension: convex
  // still.
  VALIDATE(compaction > 0.0 || s.p_a > 0.0,
           name + ": p_b = " + quote(s.p_b) + " Pa is not above R d = " + quote(s.R * s.d) + " Pa" +
               at + " (the cap would begin in tension). Is the cohesion too large?");
}

} // namespace

void DruckerPragerCap::validate(std::string const& name) const {
  validate_initial_density(name, initial_relative_density);
  validate_tables(*this, name);
  validate_ranges(*this, name);
  elasticity.validate(name);
  for (double const compaction : compactions_of_rows(*this))
    validate_shape(*this, compaction, name);
}

} // namespace continuum
