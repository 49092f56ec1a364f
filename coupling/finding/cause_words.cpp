#include "coupling/finding/cause_words.hpp"

#include <algorithm>
#include <array>

namespace coupling::finding {
namespace {

struct CauseWords {
  std::string_view name, noun, words, meaning, check;
};

// What a cause is called on the page, what it is on a press, and how to look for it there.
constexpr std::array<CauseWords, 20> causes{{
    {"frame_compliance", "compliance of the press frame", "the press frame gives way",
     "Frame, columns and punches stretch under load: the punch faces stand further apart than the "
     "travel says.",
     "Press punch on punch without powder once and note travel and force, or read the gap at the "
     "punch faces."},
    {"gap_offset", "zero of the punch gap", "the zero of the punch gap is off",
     "The gap between the punches is wrong by the same amount all the way.",
     "Bring the punches together on a gauge block and set the gap's zero."},
    {"force_gain", "gain of the load cell", "the load cell shows a wrong share of the force",
     "Every force is too high or too low by the same percentage.",
     "Check the load cell with a known weight or a second cell."},
    {"force_offset", "zero of the load cell", "the load cell is not zeroed",
     "Every force is too high or too low by the same number of newtons.",
     "Read the load cell without load and set its zero."},
    {"force_lag", "lag of the load cell", "the load cell lags behind",
     "The shown force follows the true one late, as behind a slow filter.",
     "Look up the filter of the amplifier, or hold the punch at full load and watch the reading "
     "settle."},
    {"thermal_drift", "thermal drift of the gap", "the press warms up and the gap drifts",
     "The gap changes slowly with time, whatever the force is.",
     "Let the press warm up, then watch the gap for ten minutes without load."},
    {"mass_error", "mass of the powder", "the mass of powder is wrong",
     "There was more or less powder in the die than was written down.", "Weigh the compact."},
    {"die_size", "diameter of the die", "the bore of the die has another diameter",
     "The die is worn, or its diameter was measured wrongly.",
     "Measure the bore at several heights, or the compact with a caliper."},
    {"punch_tilt", "tilt of the punch", "the punch is tilted",
     "One side of the punch face stands lower than the other.",
     "Measure the height of the compact at four places round its rim."},
    {"wall_friction", "friction at the die wall", "the die wall rubs more or less than assumed",
     "Friction between powder and die wall differs from the value of the case.",
     "Record the force on the lower punch: upper less lower is what the wall holds."},
    {"particle_friction", "friction between grains",
     "the grains rub on each other more or less than assumed",
     "Friction between grains differs from the value of the case.",
     "Record the pressure on the die wall."},
    {"young_modulus", "Young's modulus of the grains",
     "the grains are stiffer or softer than the sheet says",
     "Young's modulus of the grains differs from the material sheet.",
     "Look up the sheet of this very powder; check the load cell's gain, which looks the same."},
    {"cohesion", "cohesion of the grains", "the grains stick together more or less than assumed",
     "Cohesion between grains differs from the value of the case.",
     "Look at moisture and binder of this batch."},
    {"plastic_contacts", "yielding of the contacts", "the grains yield where they touch",
     "Contacts stay flattened: less force at full load, and less springback.",
     "Measure the height of the compact after ejection."},
    {"breakage", "breakage of grains", "grains break",
     "Crushed grains fill the voids, and the powder takes less force.",
     "Sieve the powder again after pressing."},
    {"rate_dependence", "dependence on the speed", "the powder resists fast pressing more",
     "The force depends on the speed of the press, and relaxes while the punch stands.",
     "Press once at another speed, or hold the punch at full load for a minute."},
    {"missing_fines", "fines that the simulation leaves out",
     "fine grains are missing in the simulation",
     "The powder holds fines that the simulated size distribution leaves out.",
     "Sieve or laser-size the fines of this batch."},
    {"fill_state", "packing of the filled die", "the die was filled more loosely or more densely",
     "The bed before pressing is not packed as the simulated one.",
     "Note the height of the filled bed before pressing."},
    {"die_compliance", "widening of the die", "the die widens under pressure",
     "The bore grows with the pressure on its wall.",
     "Compare the diameter of the compact with that of the bore."},
    {"multi_contact", "stiffening of squeezed grains",
     "squeezed grains stiffen at all their contacts",
     "A contact is stiffer because the same grain is pressed elsewhere, too.",
     "Press once to a higher force: only there it grows."},
}};

CauseWords const* find_words(std::string_view name) {
  auto const at = std::ranges::find(causes, name, &CauseWords::name);
  return at == causes.end() ? nullptr : &*at;
}

std::string spaced(std::string_view name) {
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

} // namespace

std::string words_of(std::string_view cause) {
  auto const* words = find_words(cause);
  return words ? std::string(words->words) : spaced(cause);
}

std::string meaning_of(std::string_view cause) {
  auto const* words = find_words(cause);
  return words ? std::string(words->meaning) : "";
}

std::string check_of(std::string_view cause) {
  auto const* words = find_words(cause);
  return words ? std::string(words->check) : "";
}

std::string with_words(std::string_view sentence) {
  auto const is_part = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
  std::string text;
  for (std::size_t k = 0; k < sentence.size();) {
    std::size_t end = k;
    while (end < sentence.size() && is_part(sentence[end]))
      ++end;
    auto const word = sentence.substr(k, std::max<std::size_t>(end - k, 1));
    auto const* words = find_words(word);
    text += words ? words->noun : word;
    k += word.size();
  }
  return text;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string channel_in_words(std::string_view channel) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 12> words{
      {{"upper_punch_force", "force on the upper punch"},
       {"lower_punch_force", "force on the lower punch"},
       {"wall_radial_pressure", "pressure on the die wall"},
       {"ejection_force", "ejection force"},
       {"punch_gap", "punch gap"},
       {"compact_height", "height of the compact"},
       {"compact_mass", "mass of the compact"},
       {"compact_diameter", "diameter of the compact"},
       {"max_force", "largest force"},
       {"gap_at_peak", "gap between the punches at the largest force"},
       {"dead_weight", "reading under the dead weight"},
       {"all", "all channels together"}}};
  auto const at = std::ranges::find(words, channel, [](auto const& one) { return one.first; });
  return at == words.end() ? spaced(channel) : std::string(at->second);
}

std::string phase_in_words(std::string_view phase) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> words{
      {{"loading", "pressing"},
       {"dwell", "holding"},
       {"unloading", "opening"},
       {"after", "after the press"}}};
  auto const at = std::ranges::find(words, phase, [](auto const& one) { return one.first; });
  return at == words.end() ? spaced(phase) : std::string(at->second);
}

} // namespace coupling::finding
