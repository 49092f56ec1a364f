#include "coupling/case_build.hpp"

#include <fmt/format.h>

namespace coupling {

namespace {

std::string const fines = "Powder/Added fines/";

/// The entries, where something reads them.
AddedFines read_fines(CaseReader& read, FillMethod method) {
  if (method != FillMethod::random) {
    read.refuse_unread(fines, fmt::format("Fill method = {} brings its own grains",
                                          read.resolved().at("Powder/Fill method")));
    return {};
  }
  double const share = read.number(fines + "Share");
  if (share == 0.0) {
    read.refuse_unread(fines, "Added fines/Share = 0");
    return {};
  }
  AddedFines const added{.share = share, .diameter = read.number(fines + "Diameter")};
  if (added.diameter == 0.0)
    read.refuse(fines + "Diameter", "leaves the added fines without a size. Give them one?");
  return added;
}

/// Every component gives its share: its mass, and with it the powder's solid volume, stays.
void add_fines(CaseReader& read, Powder& powder) {
  for (Component& component : powder.components) {
    for (SizeClass& size : component.sizes) {
      if (size.diameter <= powder.fines.diameter)
        read.refuse(fines + "Diameter",
                    fmt::format("is not finer than {:.4g} mm, a size class of {}. Choose a smaller "
                                "one?",
                                1e3 * size.diameter, component.material.name));
      size.mass_fraction *= 1.0 - powder.fines.share;
    }
    component.sizes.push_back(
        {.diameter = powder.fines.diameter, .mass_fraction = powder.fines.share});
  }
}

} // namespace

void read_fill(CaseReader& read, Powder& powder) {
  powder.fines = read_fines(read, powder.fill_method);
  if (powder.fines.share > 0.0)
    add_fines(read, powder);
  powder.fill_state = read.number("Powder/Fill state");
  if (powder.fill_state > 0.0 && powder.settle_time == 0.0)
    read.refuse("Powder/Fill state",
                "changes nothing (Settle time = 0 leaves the grains where they were put). Give "
                "them time to settle?");
}

} // namespace coupling
