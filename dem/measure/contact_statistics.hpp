#pragma once

#include "dem/contact/contact.hpp"
#include "dem/spheres.hpp"

#include <cstddef>
#include <span>

namespace dem {

/// Volume that the two grains of a contact share [m^3]; 0 for a contact with a tool.
double contact_lens(Spheres const& grains, Contact const& contact);

/// How grains touch. A contact counts where overlap > 0.
struct ContactStatistics {
  std::size_t n_grain_contacts; ///< grain with grain
  std::size_t n_tool_contacts;
  double mean_overlap;              ///< [m], over grain-grain contacts; 0 if none
  double max_overlap;               ///< [m], grain-grain
  double max_relative_overlap;      ///< [1], grain-grain, overlap / smaller radius
  double max_relative_tool_overlap; ///< [1], grain-tool, overlap / radius: at 1 the centre is in
                                    ///< the tool's face
  double coordination;              ///< [1], 2 n_grain_contacts / n_grains
  double mechanical_coordination; ///< [1], the same over the grains that are no rattlers, and their
                                  ///< contacts
  double rattler_share; ///< [1], of the grains: those with at most one contact, tools included
};

ContactStatistics measure_contacts(Spheres const& grains, ContactStream const& contacts);

} // namespace dem
