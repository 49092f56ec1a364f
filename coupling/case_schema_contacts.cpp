#include "coupling/case_schema_parts.hpp"

namespace coupling::case_entries {

using enum EntryKind;
using enum Physical;

std::vector<Entry> contact_entries() {
  std::string const at = "Contact/";
  return {
      {at + "Preset", choice, ratio, "liggghts", any, "liggghts | edem | custom",
       "Laws that go together. liggghts: hertz, sjkr2, mindlin. edem: hertz, linear_reduced, "
       "mindlin."},
      {at + "Normal law", choice, ratio, "preset", any,
       "preset | hertz | hooke | jkr | thornton_ning | edinburgh",
       "Normal force; thornton_ning and edinburgh are elasto-plastic."},
      {at + "Cohesion law", choice, ratio, "preset", any,
       "preset | none | sjkr | sjkr2 | linear_reduced | linear_hertz_circle",
       "Cohesive force k A: the name says which area A."},
      {at + "Tangential law", choice, ratio, "preset", any,
       "preset | frictionless | mindlin | hooke_spring", "Tangential force."},
      {at + "Rolling law", choice, ratio, "none", any, "none | constant_torque",
       "Resistance to rolling."},
      {at + "Friction limit", choice, ratio, "net", any, "net | elastic",
       "Normal force that limits friction: net counts cohesion (LIGGGHTS 3.3.1), elastic does not "
       "(3.8 default)."},
      {at + "Tangential damping", truth, ratio, "true", any, "",
       "Dashpot beside the tangential spring."},
      {at + "Limit force", truth, ratio, "false", any, "",
       "Clip the attraction of the normal dashpot at the end of a rebound."},
      {at + "Characteristic velocity", quantity, speed, "0.2 m/s", positive, "",
       "Impact speed at which hooke matches hertz; used by hooke only."},
      {at + "Yield pressure", quantity, modulus, "0 Pa", within(0.0, 1e13), "",
       "Pressure at which a contact yields, about 2.8 times the yield stress; used by Normal law = "
       "thornton_ning."},
      {at + "Plasticity ratio", quantity, ratio, "0", within(0.0, 0.999), "",
       "1 - k1/k2 of loading and unloading; used by Normal law = edinburgh."},
      {at + "Adhesion exponent", quantity, ratio, "1.5", within(1.0, 10.0), "",
       "Exponent chi of the adhesive branch; used by Normal law = edinburgh."},
      {at + "Viscous time", quantity, time, "0 s", within(0.0, 1e3), "",
       "A of a dashpot A dF/dd at every contact: the powder's own rate dependence."},
      {at + "Multi-contact coefficient", quantity, ratio, "0", within(0.0, 10.0), "",
       "How much a grain's contacts push each other back: share of its bulk modulus that resists "
       "the volume which they displace; 0: contacts do not know each other."},
      {at + "Precision", choice, ratio, "mixed", any, "mixed | double",
       "mixed: overlaps in double, forces in single precision."},
  };
}

std::vector<Entry> interaction_entries(std::string const& at, std::string const& cohesion) {
  return {
      {at + "Coefficient of restitution", quantity, ratio, "0.5", above_up_to(0.0, 1.0), "",
       "Rebound speed over impact speed."},
      {at + "Coefficient of static friction", quantity, ratio, "0.2", within(0.0, 10.0), "",
       "Coulomb friction."},
      {at + "Coefficient of rolling friction", quantity, ratio, "0", within(0.0, 10.0), "",
       "Used by Rolling law = constant_torque."},
      {at + "Cohesion energy density", quantity, energy_density, cohesion, within(0.0, 1e12), "",
       "k of the cohesive force k A."},
      {at + "Surface energy", quantity, surface_energy, "0 J/m^2", within(0.0, 1e4), "",
       "Work of adhesion of the pair; used by Normal law = jkr and edinburgh."},
  };
}

} // namespace coupling::case_entries
