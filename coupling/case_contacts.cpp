#include "coupling/case_build.hpp"

#include <fmt/format.h>

#include <map>

namespace coupling {

namespace {

struct PresetLaws {
  std::string normal, cohesion, tangential;
};

/// The laws of the seed's two simulators.
/// Source: LIGGGHTS-PUBLIC 3.3.1 (hertz, sjkr2 with A = 4 pi R* d); Ramirez-Aragon et al.,
/// Materials 13 (2020) 224, section 2.2 for EDEM's linear cohesion read literally (A = 2 pi R* d).
std::map<std::string, PresetLaws> const presets = {
    {"liggghts", {"hertz", "sjkr2", "mindlin"}}, {"edem", {"hertz", "linear_reduced", "mindlin"}}};

/// One law: from the preset, or named by the case; both only where they agree.
std::string read_law(CaseReader& read, std::string const& path, std::string const& preset,
                     std::string const& of_preset) {
  std::string const law = read.choice(path);
  if (of_preset.empty()) {
    if (law == "preset")
      read.refuse(
          path, "names no law (Contact/Preset = custom leaves the choice to the case). Name one?");
    return law;
  }
  if (law != "preset" && law != of_preset)
    read.refuse(
        path,
        fmt::format("contradicts Contact/Preset = {} (its law is {}). Set Contact/Preset = custom?",
                    preset, of_preset));
  read.resolve(path, of_preset);
  return of_preset;
}

/// A coefficient that only one law uses: refused where that law is not chosen, 0 where nobody asked
/// for it.
double read_if(CaseReader& read, std::string const& path, bool is_used, std::string const& reason) {
  if (is_used)
    return read.number(path);
  read.refuse_unread(path, reason);
  return 0.0;
}

dem::Interaction read_interaction(CaseReader& read, std::string const& at,
                                  dem::ContactChoice const& law) {
  return {.restitution = read.number(at + "Coefficient of restitution"),
          .static_friction = read.number(at + "Coefficient of static friction"),
          .rolling_friction = read_if(read, at + "Coefficient of rolling friction",
                                      law.rolling != "none", "Contact/Rolling law = none"),
          .cohesion_energy_density = read_if(read, at + "Cohesion energy density",
                                             law.cohesion != "none", "Contact/Cohesion law = none"),
          .surface_energy = read_if(
              read, at + "Surface energy", law.normal == "jkr" || law.normal == "edinburgh",
              fmt::format("Contact/Normal law = {}; jkr and edinburgh use it", law.normal))};
}

/// What the elasto-plastic laws need; nothing of another law.
void read_plasticity(CaseReader& read, dem::ContactChoice& law) {
  std::string const at = "Contact/";
  std::string const unused = fmt::format("Contact/Normal law = {}; ", law.normal);
  law.yield_pressure = read_if(read, at + "Yield pressure", law.normal == "thornton_ning",
                               unused + "thornton_ning uses it");
  if (law.normal == "thornton_ning" && law.yield_pressure == 0.0)
    read.refuse(at + "Yield pressure",
                "leaves Contact/Normal law = thornton_ning without strength. About 2.8 times the "
                "yield stress?");
  law.plasticity_ratio = read_if(read, at + "Plasticity ratio", law.normal == "edinburgh",
                                 unused + "edinburgh uses it");
}

} // namespace

Contacts read_contacts(CaseReader& read) {
  std::string const at = "Contact/";
  std::string const preset = read.choice(at + "Preset");
  PresetLaws const laws = preset == "custom" ? PresetLaws{} : presets.at(preset);
  Contacts contacts;
  contacts.law = {.normal = read_law(read, at + "Normal law", preset, laws.normal),
                  .cohesion = read_law(read, at + "Cohesion law", preset, laws.cohesion),
                  .tangential = read_law(read, at + "Tangential law", preset, laws.tangential),
                  .rolling = read.choice(at + "Rolling law"),
                  .friction_limit = read.choice(at + "Friction limit"),
                  .tangential_damping = read.truth(at + "Tangential damping"),
                  .clip_attractive_damping = read.truth(at + "Limit force"),
                  .characteristic_velocity = read.number(at + "Characteristic velocity"),
                  .adhesion_exponent = read.number(at + "Adhesion exponent"),
                  .viscous_time = read.number(at + "Viscous time"),
                  .multi_contact = read.number(at + "Multi-contact coefficient"),
                  .precision = read.choice(at + "Precision") == "double" ? dem::Precision::full
                                                                         : dem::Precision::mixed};
  read_plasticity(read, contacts.law);
  bool const is_adhesive = contacts.law.normal == "jkr" || contacts.law.normal == "edinburgh";
  if (is_adhesive && contacts.law.cohesion != "none")
    read.refuse(at + "Cohesion law",
                fmt::format("doubles the adhesion of Contact/Normal law = {}. Set Cohesion law = "
                            "none?",
                            contacts.law.normal));
  contacts.grain_grain = read_interaction(read, at + "Particle-particle/", contacts.law);
  contacts.grain_wall = read_interaction(read, at + "Particle-wall/", contacts.law);
  return contacts;
}

} // namespace coupling
