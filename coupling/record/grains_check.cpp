#include "coupling/record/grains_check.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace coupling {
namespace {

struct GrainsChecker {
  H5Reader const& file;
  std::string const& folder;
  std::size_t n_grains;

  template <class T> std::vector<T> load(std::string const& field) const {
    auto values = file.get<std::vector<T>>(folder + field);
    VALIDATE(
        values.size() == n_grains,
        fmt::format(
            "{}: {}{} has {} rows for {} grains. Was it written by another version of presscheck?",
            file.name().string(), folder, field, values.size(), n_grains));
    return values;
  }

  void refuse_unless(bool good, std::string const& field, std::size_t row,
                     std::string const& why) const {
    VALIDATE(good, fmt::format("{}: {}{}[{}] {}. Take an older restart?", file.name().string(),
                               folder, field, row, why));
  }

  void finite(std::string const& field) const {
    auto const values = load<dem::Vec3>(field);
    for (std::size_t i = 0; i < values.size(); ++i)
      refuse_unless(values[i].allFinite(), field, i, "is not finite");
  }

  void positive(std::string const& field) const {
    auto const values = load<double>(field);
    for (std::size_t i = 0; i < values.size(); ++i)
      refuse_unless(std::isfinite(values[i]) && values[i] > 0.0, field, i,
                    fmt::format("= {} (a positive number is needed)", values[i]));
  }

  void permutation(std::string const& field) const {
    auto const ids = load<std::uint32_t>(field);
    std::vector<bool> seen(n_grains, false);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      refuse_unless(ids[i] < n_grains && !seen[ids[i]], field, i,
                    fmt::format("= {} (each of 0 to {} must occur once)", ids[i], n_grains - 1));
      seen[ids[i]] = true;
    }
  }
};

} // namespace

void check_grains(H5Reader const& file, std::string const& folder) {
  auto const n_grains = file.get<std::vector<dem::Vec3>>(folder + "position").size();
  GrainsChecker const check{file, folder, n_grains};
  for (auto const* field : {"position", "velocity", "spin", "force", "torque"})
    if (file.has(folder + field))
      check.finite(field);
  for (auto const* field : {"radius", "mass"})
    check.positive(field);
  check.permutation("id");
  check.load<std::uint8_t>("material");
}

} // namespace coupling
