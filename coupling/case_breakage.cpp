#include "coupling/case_build.hpp"

namespace coupling {

BreakageLaw read_breakage(CaseReader& read) {
  std::string const at = "Breakage/";
  double const strength = read.number(at + "Strength");
  if (strength == 0.0) {
    read.refuse_unread(at, "Breakage/Strength = 0: grains do not break");
    return {};
  }
  return {.strength = strength,
          .weibull_modulus = read.number(at + "Weibull modulus"),
          .reference_diameter = read.number(at + "Reference diameter"),
          .smallest_diameter = read.number(at + "Smallest diameter")};
}

} // namespace coupling
