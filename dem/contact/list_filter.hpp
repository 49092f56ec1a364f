#pragma once

#include "dem/contact/contact_lists.hpp"

namespace dem {

/// Tools that grain i may reach while `age` holds.
std::vector<NearTool> tools_near(World const& world, ListAge const& age, std::size_t i,
                                 double reach);

/// Fills one block of the inner list: pairs and walls of its rows with constants and carried
/// histories.
template <class T>
void fill_block(World const& world, ContactKernel<T> const& kernel, ContactChoice const& choice,
                PairTable const& table, double reach, CarriedContacts<T> const& carried,
                ContactLists<T> const& lists, ContactBlock<T>& block);

/// Sizes of a pair of grains, or of a grain at a tool.
PairSize pair_size(Spheres const& grains, std::size_t i, std::size_t j);
PairSize wall_size(Spheres const& grains, std::size_t i);

} // namespace dem
