#include "dem/packing/packing_file.hpp"

#include "dem/expect.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

namespace dem {
namespace {

constexpr std::array<std::string_view, 11> column_names = {
    "x [m]",    "y [m]",    "z [m]",      "diameter [m]", "component", "vx [m/s]",
    "vy [m/s]", "vz [m/s]", "wx [rad/s]", "wy [rad/s]",   "wz [rad/s]"};
enum Column { x, y, z, diameter, component, vx, vy, vz, wx, wy, wz };
constexpr std::size_t n_required = 5;
constexpr std::size_t absent = static_cast<std::size_t>(-1);

using Fields = std::vector<std::string_view>;

std::string quoted(std::string_view text) {
  return std::string(1, '\'').append(text) + '\'';
}

std::string_view trimmed(std::string_view text) {
  auto const begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

Fields split(std::string_view line) {
  Fields fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    auto const end = std::min(line.find(',', begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+'))
    text.remove_prefix(1);
  double value = 0.0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

/// Where in the file we are: every message begins with it.
struct Place {
  std::string const& name;
  std::size_t line;

  std::string operator()(std::string const& problem) const {
    return name + ":" + std::to_string(line) + ": " + problem;
  }
};

/// Which field of a line holds which column.
struct Header {
  std::array<std::size_t, column_names.size()> field;
  std::size_t n_fields;

  bool has(Column column) const { return field[column] != absent; }
};

Header read_header(std::string_view line, Place const& at) {
  Fields const fields = split(line);
  Header header{.field = {}, .n_fields = fields.size()};
  header.field.fill(absent);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    auto const known = std::ranges::find(column_names, fields[k]);
    VALIDATE(known != column_names.end(),
             at("unknown column " + quoted(fields[k]) +
                " (columns carry their unit, as in 'x [m]'). Is it misspelt?"));
    auto& field = header.field[static_cast<std::size_t>(known - column_names.begin())];
    VALIDATE(field == absent, at("column " + quoted(*known) + " occurs twice. Which one counts?"));
    field = k;
  }
  for (std::size_t k = 0; k < column_names.size(); ++k) {
    bool const needed =
        k < n_required || (k < wx ? header.has(vx) || header.has(vy) || header.has(vz)
                                  : header.has(wx) || header.has(wy) || header.has(wz));
    VALIDATE(!needed || header.field[k] != absent,
             at("column " + quoted(column_names[k]) + " is missing (" +
                (k < n_required ? "a packing needs it" : "a vector has three components") +
                "). Does the first line name the columns?"));
  }
  return header;
}

std::uint8_t find_component(std::string_view text, std::span<PackingComponent const> components,
                            Place const& at) {
  auto const named = std::ranges::find(components, text, &PackingComponent::name);
  if (named != components.end())
    return static_cast<std::uint8_t>(named - components.begin());
  auto const number = parse_number(text);
  bool const is_row = number && *number >= 1.0 &&
                      *number <= static_cast<double>(components.size()) &&
                      *number == std::floor(*number);
  std::string known;
  for (PackingComponent const& each : components)
    known += (known.empty() ? "" : ", ") + each.name;
  VALIDATE(is_row, at("component = " + quoted(text) + " is not in the powder (known: " + known +
                      ", or their numbers from 1). Is it the case's packing?"));
  return static_cast<std::uint8_t>(*number - 1.0);
}

/// Reads the grain on one line.
struct GrainReader {
  Header const& header;
  Fields const& fields;
  Place const& at;

  double number(Column column) const {
    std::string_view const text = fields[header.field[column]];
    auto const value = parse_number(text);
    std::string const entry = std::string(column_names[column]) + " = " + quoted(text);
    VALIDATE(value.has_value(), at(entry + " is not a number. Is the file damaged?"));
    VALIDATE(std::isfinite(*value), at(entry + " is not finite. Did the run that wrote it fail?"));
    return *value;
  }

  Vec3 vector(Column first) const {
    if (!header.has(first))
      return Vec3::Zero();
    return {number(first), number(static_cast<Column>(first + 1)),
            number(static_cast<Column>(first + 2))};
  }

  PackedGrain operator()(std::span<PackingComponent const> components) const {
    VALIDATE(fields.size() == header.n_fields,
             at(std::to_string(fields.size()) + " fields (the header has " +
                std::to_string(header.n_fields) + "). Is the line cut off?"));
    double const size = number(diameter);
    VALIDATE(size > 0.0, at("diameter [m] = " + std::string(fields[header.field[diameter]]) +
                            " (a grain has a positive one). Is the sign right?"));
    return {.position = vector(x),
            .diameter = size,
            .component = find_component(fields[header.field[component]], components, at),
            .velocity = vector(vx),
            .spin = vector(wx)};
  }
};

std::string write_number(double value) {
  std::array<char, 32> text; // the shortest text that reads back to the same bits takes at most 24
  auto const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/// The component's name where it survives the journey, else its number.
std::string write_component(std::uint8_t row, std::span<PackingComponent const> components) {
  std::string const& name = components[row].name;
  auto const first = std::ranges::find(components, name, &PackingComponent::name);
  bool const is_plain = name == trimmed(name) && name.find_first_of(",\n") == std::string::npos;
  bool const is_unique = !name.empty() && first - components.begin() == row;
  return is_plain && is_unique ? name : std::to_string(row + 1);
}

void write_line(std::ostream& out, PackedGrain const& grain,
                std::span<PackingComponent const> components) {
  for (double value : grain.position)
    out << write_number(value) << ',';
  out << write_number(grain.diameter) << ',' << write_component(grain.component, components);
  for (double value : grain.velocity)
    out << ',' << write_number(value);
  for (double value : grain.spin)
    out << ',' << write_number(value);
  out << '\n';
}

} // namespace

Packing read_packing(std::istream& in, std::string const& name,
                     std::span<PackingComponent const> components) {
  Packing packing;
  std::optional<Header> header;
  std::string line;
  for (std::size_t n = 1; std::getline(in, line); ++n) {
    if (n == 1 && line.starts_with("\xef\xbb\xbf"))
      line.erase(0, 3); // byte order mark of spreadsheets
    if (trimmed(line).empty())
      continue;
    Place const at{name, n};
    if (!header) {
      header = read_header(line, at);
      continue;
    }
    Fields const fields = split(line);
    packing.push_back(GrainReader{*header, fields, at}(components));
  }
  VALIDATE(!in.bad(), name + ": reading failed half-way. Is the disk all right?");
  VALIDATE(header.has_value(), name + ":1: the file is empty (a packing has a header and grains)");
  VALIDATE(!packing.empty(),
           name + ":1: there are no grains under the header. Was the writing stopped?");
  return packing;
}

Packing read_packing(std::filesystem::path const& file,
                     std::span<PackingComponent const> components) {
  VALIDATE(!std::filesystem::is_directory(file),
           file.string() + ": is a folder (a packing is a CSV file)");
  std::ifstream in(file, std::ios::binary);
  VALIDATE(in.is_open(), file.string() + ": cannot be opened. Is the path right?");
  return read_packing(in, file.string(), components);
}

void write_packing(std::filesystem::path const& file, Packing const& packing,
                   std::span<PackingComponent const> components) {
  std::filesystem::path part = file;
  part += ".part";
  std::ofstream out(part, std::ios::binary);
  VALIDATE(out.is_open(),
           file.string() + ": cannot be written. Does the folder exist and allow it?");
  for (std::size_t k = 0; k < column_names.size(); ++k)
    out << (k ? "," : "") << column_names[k];
  out << '\n';
  for (PackedGrain const& grain : packing)
    write_line(out, grain, components);
  out.close();
  std::error_code failed;
  if (out)
    std::filesystem::rename(part, file, failed);
  if (out && !failed)
    return;
  std::filesystem::remove(part, failed);
  throw InvalidInput(file.string() + ": could not be written to its end. Is the disk full?");
}

} // namespace dem
