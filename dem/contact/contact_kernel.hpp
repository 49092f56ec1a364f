#pragma once

#include "dem/contact/contact_block.hpp"
#include "dem/contact/contact_model.hpp"
#include "dem/spheres.hpp"
#include "dem/step/world_fwd.hpp"

#include <span>
#include <string>

namespace dem {

template <class T> struct Crowding;

/// What a sweep reads besides the block, and where the loads go.
template <class T> struct SweepInput {
  Spheres const& grains;
  MotionRecord<T> const* motions;
  LoadRecord<T>* own_loads;  ///< written, as in ContactLists
  LoadRecord<T>* halo_loads; ///< written
  std::span<Tool const> tools;
  ModelSwitches<T> switches;
  double dt;                   ///< [s]; 0: forces only, the springs stay as they are
  double window_time;          ///< [s], since the window of the deformable tools began
  Crowding<T> const* crowding; ///< of each row; null: contacts do not know each other
};

/// A contact model behind a table of functions, so that it is chosen once a sweep and inlined
/// inside it.
template <class T> struct ContactKernel {
  int n_constants;
  bool has_memory;
  /// Writes the n_constants numbers of one contact.
  void (*constants)(PairMaterial const&, PairSize const&, ContactChoice const&, double* out);
  /// Distance beyond touch at which the contact can act [m], from its constants.
  double (*reach)(double const* constants);
  /// Forces of every contact of the block into its places of the loads; advances the springs if dt
  /// > 0.
  void (*sweep)(ContactBlock<T>&, SweepInput<T> const&);
  /// One contact in full precision, nothing remembered.
  ContactOutput<double> (*evaluate)(ContactInput<double> const&, double const* constants,
                                    ModelSwitches<double> const&, ContactMemory<double> memory);
  /// Stored energy [J]: elastic and cohesive part.
  struct Energy {
    double elastic, cohesive;
  };
  Energy (*energy)(double const* constants, double overlap, double memory, double radius_i,
                   double radius_j);
  /// Tangent stiffness [N/m] and dashpot [kg/s] along the normal and in the tangent plane, for the
  /// stable step.
  struct Stiffness {
    double normal, tangential, normal_dashpot, tangential_dashpot;
  };
  Stiffness (*stiffness)(double const* constants, double overlap, double memory);
};

/// The kernel of the named laws. @throws InvalidInput for an unknown name or laws that do not go
/// together, with a list of the known ones
template <class T> ContactKernel<T> make_kernel(ContactChoice const& choice);

extern template ContactKernel<float> make_kernel<float>(ContactChoice const&);
extern template ContactKernel<double> make_kernel<double>(ContactChoice const&);

} // namespace dem
