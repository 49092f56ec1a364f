#include "continuum/powder/elasticity.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/quote.hpp"

namespace continuum {

void DensityElasticity::validate(std::string const& name) const {
  young_modulus.validate(name + ", Young's modulus", "relative density");
  poisson_ratio.validate(name + ", Poisson's ratio", "relative density");
  VALIDATE(young_modulus.smallest() > 0.0,
           name + ": Young's modulus = " + quote(young_modulus.smallest()) +
               " Pa (a body that resists needs a positive one). Is the unit right?");
  for (double const nu : {poisson_ratio.smallest(), poisson_ratio.largest()})
    VALIDATE(nu > -1.0 && nu < 0.5, name + ": Poisson's ratio = " + quote(nu) +
                                        " (elastic energy is positive only between -1 and 0.5). "
                                        "Powders have 0 to 0.35?");
}

void PressureElasticity::validate(std::string const& name) const {
  VALIDATE(kappa > 0.0, name + ": kappa = " + quote(kappa) +
                            " (a positive one gives a bulk modulus p/kappa). Is it on volumetric "
                            "strain?");
  VALIDATE(shear_modulus > 0.0, name + ": shear modulus = " + quote(shear_modulus) +
                                    " Pa (a body that resists needs a positive one). Is the unit "
                                    "right?");
  VALIDATE(reference_pressure + cohesion > 0.0,
           name + ": reference pressure = " + quote(reference_pressure) +
               " Pa with cohesion = " + quote(cohesion) +
               " Pa (the bulk modulus (p + c)/kappa is positive). Raise the initial pressure?");
}

} // namespace continuum
