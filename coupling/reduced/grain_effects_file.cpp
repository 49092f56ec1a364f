#include "coupling/reduced/grain_library.hpp"

#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace coupling::reduced {
namespace {

using Json = nlohmann::ordered_json;

/// Four digits: more is the packing's.
double rounded(double value) {
  return value == 0.0 || !std::isfinite(value) ? value : std::stod(fmt::format("{:.4g}", value));
}

Json by_name(BedNumbers const& numbers) {
  Json object;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    object[std::string(bed_numbers[k])] = rounded(numbers[k]);
  return object;
}

Json effect_json(GrainEffect const& effect) {
  return {{"factor", effect.factor},
          {"measure", effect.measure},
          {"low", rounded(effect.low)},
          {"middle", rounded(effect.middle)},
          {"high", rounded(effect.high)},
          {"seeds", effect.n_seeds},
          {"slope", by_name(effect.slope)},
          {"standard_error", by_name(effect.error)},
          {"rms_before", rounded(effect.before)},
          {"rms_after", rounded(effect.after)}};
}

Json plastic_json(PlasticEffect const& effect) {
  auto const numbers = [](PlasticChange const& c) {
    return Json{{"yielding.size", rounded(c.yielding.size)},
                {"yielding.stress", rounded(c.yielding.stress)},
                {"r", rounded(c.recovery)},
                {"ln p", rounded(c.ln_opening)}};
  };
  return {{"yield_pressure", effect.yield_pressure},
          {"seeds", effect.n_seeds},
          {"change", numbers(effect.mean)},
          {"standard_error", numbers(effect.error)}};
}

BedNumbers numbers_in(Json const& object) {
  BedNumbers numbers{};
  for (std::size_t k = 0; k < numbers.size(); ++k)
    numbers[k] = object.at(std::string(bed_numbers[k])).get<double>();
  return numbers;
}

GrainEffect effect_in(Json const& object) {
  return {.factor = object.at("factor"),
          .measure = object.at("measure"),
          .low = object.at("low"),
          .middle = object.at("middle"),
          .high = object.at("high"),
          .n_seeds = object.at("seeds"),
          .slope = numbers_in(object.at("slope")),
          .error = numbers_in(object.at("standard_error")),
          .before = object.at("rms_before"),
          .after = object.at("rms_after")};
}

} // namespace

std::string library_json(GrainLibrary const& library, std::string const& command) {
  Json effects = Json::array(), plastic = Json::array();
  for (auto const& effect : library.effects)
    effects.push_back(effect_json(effect));
  for (auto const& effect : library.plastic)
    plastic.push_back(plastic_json(effect));
  Json const all{
      {"what", "what causes on the grains' side do to the numbers of the bed law "
               "(coupling/reduced/bed_law.hpp), one factor at a time, paired packing seeds"},
      {"command", command},
      {"runs", library.n_runs},
      {"units", "slopes per unit of `measure`: ln K, ln S, ln p, phi_c, n, r, mu, k [1]; "
                "yield_pressure, yielding.stress [Pa]; rms: share of the peak force, both punches, "
                "loading and unloading, at low and high, of the middle's law without and with "
                "the effect"},
      {"middle",
       {{"stiffness", rounded(library.middle.stiffness)},
        {"cohesion", rounded(library.middle.cohesion)},
        {"onset", rounded(library.middle.onset)},
        {"exponent", rounded(library.middle.exponent)},
        {"recovery", rounded(library.middle.recovery)},
        {"wall_friction", rounded(library.middle.wall_friction)},
        {"radial_ratio", rounded(library.middle.radial_ratio)},
        {"standard_deviation_of_a_seed", by_name(library.middle_error)}}},
      {"effects", effects},
      {"plastic_contacts", plastic}};
  return all.dump(2) + "\n";
}

std::vector<GrainEffect> read_effects(std::filesystem::path const& file) {
  try {
    std::vector<GrainEffect> effects;
    auto const all = Json::parse(read_file(file));
    for (auto const& object : all.at("effects"))
      effects.push_back(effect_in(object));
    return effects;
  } catch (nlohmann::json::exception const& problem) {
    throw dem::InvalidInput(fmt::format("{}: is no table of grain effects ({}). Was it written by "
                                        "grain_effects?",
                                        file.string(), problem.what()));
  }
}

} // namespace coupling::reduced
