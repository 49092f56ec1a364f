#include "continuum/powder/powder_law.hpp"

namespace continuum {

PowderResult respond(PowderLaw const& law, PowderState const& old,
                     Eigen::Vector3d const& trial_strain) {
  return std::visit([&](auto const& l) { return l.respond(old, trial_strain); }, law);
}

double relative_density(PowderLaw const& law, PowderState const& state) {
  return std::visit([&](auto const& l) { return l.relative_density(state); }, law);
}

void validate(PowderLaw const& law, std::string const& name) {
  std::visit([&](auto const& l) { l.validate(name); }, law);
}

} // namespace continuum
