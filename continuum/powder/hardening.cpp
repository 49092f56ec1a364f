#include "continuum/powder/hardening.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/quote.hpp"

namespace continuum {

void validate_initial_density(std::string const& name, double relative_density) {
  VALIDATE(relative_density > 0.0 && relative_density < 1.0,
           name + ": initial relative density = " + quote(relative_density) +
               " (a powder fills part of its volume: between 0 and 1). Is it in percent?");
}

void IndexHardening::validate(std::string const& name, double) const {
  VALIDATE(kappa >= 0.0 && kappa < lambda,
           name + ": kappa = " + quote(kappa) + " is not below lambda = " + quote(lambda) +
               " (recompression is stiffer than first compression). Are they interchanged?");
  VALIDATE(preconsolidation > 0.0, name + ": preconsolidation = " + quote(preconsolidation) +
                                       " Pa (hardening multiplies it). Is the unit right?");
}

void HeckelHardening::validate(std::string const& name, double initial_density) const {
  VALIDATE(reference_density > 0.0 && reference_density < 1.0,
           name + ": reference density of the hardening = " + quote(reference_density) +
               " (a relative density is between 0 and 1). Is it in percent?");
  VALIDATE(yield_pressure > 0.0,
           name + ": yield pressure = " + quote(yield_pressure) +
               " Pa (a powder hardens as it densifies). Is it 1/K of Heckel's plot?");
  VALIDATE((*this)(0.0, initial_density) > 0.0,
           name + ": p_c = " + quote((*this)(0.0, initial_density)) +
               " Pa at the initial density (the elastic range must not be empty). Raise the "
               "initial pressure?");
}

void TabulatedHardening::validate(std::string const& name, double initial_density) const {
  pressure.validate(name + ", hardening", "relative density");
  VALIDATE(pressure.rows.size() > 1, name + ": the hardening has one row (its last two carry it on "
                                            "towards the solid). Give a second?");
  auto const& end = pressure.rows.back();
  VALIDATE(end.x < 1.0, name + ": hardening at relative density = " + quote(end.x) +
                            " (a powder stays below 1). End the table before it?");
  VALIDATE(pressure.is_ascending() && end.value > pressure.rows[pressure.rows.size() - 2].value,
           name + ": the hardening falls, or ends flat (a powder hardens as it densifies). Are the "
                  "rows in order?");
  VALIDATE(pressure(initial_density) > 0.0,
           name + ": p_c = " + quote(pressure(initial_density)) +
               " Pa at the initial density (the elastic range must not be empty). Add a row?");
}

} // namespace continuum
