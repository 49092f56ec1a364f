#pragma once

#include "dem/contact/contact_lists.hpp"
#include "dem/contact/crowding.hpp"

#include <vector>

/// Contacts of one grain that know of each other. A contact c displaces the volume v_c of each of
/// its grains, which must go somewhere: the grain's pressure against contact c is
///   p_ic = b K_i (S_i - v_c) / V_i,   S_i = sum of v over the contacts of grain i,
///   v_c = pi/2 R* d^2,   K = E / (3 (1 - 2 nu)),   V_i = 4/3 pi R_i^3,
/// and it acts on the area that the contact displaces with, A_c = dv_c/dd = pi R* d:
///   F_c = F_law + A_c (p_ic + p_jc)
/// (at a tool the grain's own p alone). A grain with one contact feels nothing of it. The extra
/// force has a potential, so the ledger's elastic energy holds it:
///   U = sum over grains of b K_i / (2 V_i) (S_i^2 - sum of v_c^2).
/// All of it is formed from the positions of the present step: nothing lags, nothing is remembered.
/// The form F_H + b p A is that of Brodu, Dijksman and Behringer, Phys. Rev. E 91 (2015) 032201,
/// and Giannis et al., Granular Matter 23 (2021) 17, who take p from the grain's mean stress, which
/// has no potential; b = 1 is a grain that gives way to volume as its solid does.
namespace dem {

/// Crowding of every grain of a world, in the order of rows. Blocks sum for their own grains and
/// for foreign partners, and each grain sums over blocks in their order, as loads are: the same
/// bits on any number of threads.
template <class T> class CrowdingField {
public:
  /// @param coefficient  b; 0 leaves the field empty
  template <class U>
  void form(World const& world, ContactLists<U> const& lists, double coefficient);

  std::size_t bytes() const; ///< of memory
  bool is_empty() const { return grains_.empty(); }
  Crowding<T> const* data() const { return grains_.empty() ? nullptr : grains_.data(); }
  Crowding<T> const& operator[](std::size_t row) const { return grains_[row]; }

private:
  std::vector<Crowding<T>> grains_;
  std::vector<double> own_, halo_; // displaced volumes [m^3], see ContactLists::own_loads
};

} // namespace dem
