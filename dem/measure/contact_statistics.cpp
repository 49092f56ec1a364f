#include "dem/measure/contact_statistics.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace dem {
namespace {

std::vector<std::uint32_t> count_per_grain(Spheres const& grains,
                                           std::span<Contact const> contacts) {
  std::vector<std::uint32_t> counts(grains.size(), 0);
  for (Contact const& contact : contacts) {
    if (contact.overlap <= 0.0)
      continue;
    ++counts[contact.i];
    if (contact.j != Contact::none)
      ++counts[contact.j];
  }
  return counts;
}

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

ContactStatistics measure_contacts(Spheres const& grains, std::span<Contact const> contacts) {
  auto const counts = count_per_grain(grains, contacts);
  auto const is_rattler = [&](std::uint32_t i) { return counts[i] <= 1; };
  ContactStatistics result{};
  double sum = 0.0, n_mechanical = 0.0;
  for (Contact const& contact : contacts) {
    if (contact.overlap <= 0.0)
      continue;
    double const R = grains.radius[contact.i];
    if (contact.j == Contact::none) {
      ++result.n_tool_contacts;
      result.max_relative_tool_overlap =
          std::max(result.max_relative_tool_overlap, contact.overlap / R);
      continue;
    }
    ++result.n_grain_contacts;
    sum += contact.overlap;
    result.max_overlap = std::max(result.max_overlap, contact.overlap);
    result.max_relative_overlap = std::max(result.max_relative_overlap,
                                           contact.overlap / std::min(R, grains.radius[contact.j]));
    if (!is_rattler(contact.i) && !is_rattler(contact.j))
      n_mechanical += 1.0;
  }
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
