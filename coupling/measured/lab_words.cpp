#include "coupling/measured/lab_words.hpp"

#include "coupling/measured/lab_text.hpp"
#include "coupling/trimmed.hpp"

#include <algorithm>
#include <array>

namespace coupling::measured {
namespace {

struct Words {
  std::string_view column;
  std::vector<std::string_view> names; ///< folded
};

std::vector<Words> const& vocabulary() {
  static std::vector<Words> const all = {
      {"time",
       {"time", "t", "elapsed time", "test time", "run time", "zeit", "prufzeit", "pruefzeit",
        "messzeit", "zeitstempel", "tiempo", "tiempo transcurrido", "tiempo de ensayo"}},
      {"upper_punch_force",
       {"upper punch force",
        "upper force",
        "force",
        "load",
        "axial force",
        "press force",
        "f",
        "kraft",
        "last",
        "presskraft",
        "prufkraft",
        "pruefkraft",
        "standardkraft",
        "oberkraft",
        "oberstempelkraft",
        "kraft oben",
        "fuerza",
        "carga",
        "fuerza superior",
        "fuerza del punzon superior"}},
      {"lower_punch_force",
       {"lower punch force", "lower force", "bottom force", "unterkraft", "unterstempelkraft",
        "kraft unten", "fuerza inferior", "fuerza del punzon inferior"}},
      {"wall_radial_pressure",
       {"wall radial pressure", "radial pressure", "wall pressure", "die wall pressure",
        "radialdruck", "wanddruck", "matrizendruck", "presion radial", "presion de pared"}},
      {"ejection_force",
       {"ejection force", "ausstosskraft", "auswerferkraft", "fuerza de expulsion",
        "fuerza de eyeccion"}},
      {"punch_gap",
       {"punch gap", "gap", "punch distance", "abstand", "stempelabstand", "spalt", "spaltweite",
        "distancia", "separacion", "distancia entre punzones"}},
      {"travel",
       {"displacement", "travel", "stroke", "position", "extension", "crosshead",
        "crosshead position", "crosshead displacement", "punch displacement", "weg", "traversenweg",
        "stempelweg", "hub", "verfahrweg", "desplazamiento", "recorrido", "posicion", "carrera"}}};
  return all;
}

/// Symbol in brackets at the end of a field.
bool split_brackets(std::string const& field, char open, char close, ColumnHeader& header) {
  if (!field.ends_with(close))
    return false;
  auto const at = field.rfind(open);
  if (at == std::string::npos || at == 0)
    return false;
  header = {trimmed(field.substr(0, at)), trimmed(field.substr(at + 1, field.size() - at - 2))};
  return !header.name.empty() && !header.unit.empty();
}

} // namespace

ColumnHeader parse_column_header(std::string_view text) {
  std::string const field = trimmed(text);
  ColumnHeader header{field, {}};
  if (split_brackets(field, '[', ']', header) || split_brackets(field, '(', ')', header))
    return header;
  for (std::string_view const between : {" / ", " in ", " en "})
    if (auto const at = field.rfind(between); at != std::string::npos && at > 0) {
      ColumnHeader split{trimmed(field.substr(0, at)), trimmed(field.substr(at + between.size()))};
      // "Distance in die" is a name.
      if (!split.unit.empty() && split.unit.find(' ') == std::string::npos)
        return split;
    }
  return {field, {}};
}

std::string recognised_column(std::string_view name) {
  std::string const plain = folded(name);
  // Symbols have their case: T is a temperature, f a frequency.
  if (plain.size() == 1)
    return name == "t" ? "time" : name == "F" ? "upper_punch_force" : "";
  for (auto const& [column, names] : vocabulary())
    if (std::ranges::find(names, plain) != names.end())
      return std::string(column);
  return {};
}

std::vector<std::string> const& recognised_names() {
  static std::vector<std::string> const names = [] {
    std::vector<std::string> all;
    for (auto const& words : vocabulary())
      all.insert(all.end(), words.names.begin(), words.names.end());
    return all;
  }();
  return names;
}

std::string unit_symbol(std::string_view written) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 29> spellings = {
      {{"sec", "s"},     {"secs", "s"},      {"second", "s"},    {"seconds", "s"},
       {"Sek", "s"},     {"Sek.", "s"},      {"sek", "s"},       {"Sekunden", "s"},
       {"seg", "s"},     {"seg.", "s"},      {"segundos", "s"},  {"S", "s"},
       {"Min", "min"},   {"Minuten", "min"}, {"minutes", "min"}, {"minutos", "min"},
       {"msec", "ms"},   {"KN", "kN"},       {"kn", "kN"},       {"n", "N"},
       {"MM", "mm"},     {"Mm", "mm"},       {"M", "m"},         {"Pascal", "Pa"},
       {"N/mm2", "MPa"}, {"N/mm²", "MPa"},   {"N/mm^2", "MPa"},  {"Mpa", "MPa"},
       {"N/m²", "Pa"}}};
  auto const found = std::ranges::find(spellings, written, [](auto const& s) { return s.first; });
  return std::string(found == spellings.end() ? written : found->second);
}

} // namespace coupling::measured
