#include "dem/measure/contact_statistics.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace dem {
namespace {

double ratio(double numerator, double denominator) {
  return denominator > 0.0 ? numerator / denominator : 0.0;
}

} // namespace

double contact_lens(Spheres const& grains, Contact const& contact) {
  if (contact.j == Contact::none)
    return 0.0;
  double const Ri = grains.radius[contact.i], Rj = grains.radius[contact.j];
  return lens_volume(Ri, Rj, Ri + Rj - contact.overlap);
}

ContactStatistics measure_contacts(Spheres const& grains, ContactStream const& contacts) {
  std::vector<std::uint32_t> counts(grains.size(), 0);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  ContactStatistics result{};
  double sum = 0.0;
  contacts.for_each([&](Contact const& contact) {
    if (contact.overlap <= 0.0)
      return;
    double const R = grains.radius[contact.i];
    ++counts[contact.i];
    if (contact.j == Contact::none) {
      ++result.n_tool_contacts;
      result.max_relative_tool_overlap =
          std::max(result.max_relative_tool_overlap, contact.overlap / R);
      return;
    }
    ++counts[contact.j];
    pairs.push_back({contact.i, contact.j});
    sum += contact.overlap;
    result.max_overlap = std::max(result.max_overlap, contact.overlap);
    result.max_relative_overlap = std::max(result.max_relative_overlap,
                                           contact.overlap / std::min(R, grains.radius[contact.j]));
  });
  result.n_grain_contacts = pairs.size();
  auto const n_mechanical = static_cast<double>(std::ranges::count_if(
      pairs, [&](auto const& pair) { return counts[pair[0]] > 1 && counts[pair[1]] > 1; }));
  double const n_grains = static_cast<double>(grains.size());
  double const n_rattlers =
      static_cast<double>(std::ranges::count_if(counts, [](std::uint32_t n) { return n <= 1; }));
  double const n_contacts = static_cast<double>(result.n_grain_contacts);
  result.mean_overlap = ratio(sum, n_contacts);
  result.coordination = ratio(2.0 * n_contacts, n_grains);
  result.mechanical_coordination = ratio(2.0 * n_mechanical, n_grains - n_rattlers);
  result.rattler_share = ratio(n_rattlers, n_grains);
  return result;
}

} // namespace dem
