#include "coupling/case_file.hpp"

#include "coupling/case_build.hpp"
#include "coupling/case_print.hpp"
#include "coupling/case_schema.hpp"
#include "coupling/case_text.hpp"
#include "coupling/case_value.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <sstream>

// The only file that knows dealii::ParameterHandler. It stands between two texts: what the scanners
// found, with lines, and the CaseText of every entry, which the rest of the reading is built on.
static_assert(__cplusplus >= 202002L,
              "deal.II's exported flags ask for C++17; ours come after them");

namespace coupling {

namespace {

/// An entry of the schema as deal.II wants to know it.
class EntryPattern : public dealii::Patterns::PatternBase {
public:
  explicit EntryPattern(Entry const& entry) : entry_(entry) {}

  bool match(std::string const& text) const override {
    try {
      check_value(entry_, text);
      return true;
    } catch (dem::InvalidInput const&) {
      return false;
    }
  }
  std::string description(OutputStyle) const override { return "[" + describe_range(entry_) + "]"; }
  std::unique_ptr<PatternBase> clone() const override {
    return std::make_unique<EntryPattern>(entry_);
  }

private:
  Entry const& entry_;
};

/// Does something inside the section of an entry and comes back to the top.
template <class Action>
void in_section(dealii::ParameterHandler& handler, std::string_view section, Action&& action) {
  if (section.empty())
    return action();
  auto const slash = section.find('/');
  handler.enter_subsection(std::string(section.substr(0, slash)));
  in_section(handler,
             slash == std::string_view::npos ? std::string_view{} : section.substr(slash + 1),
             action);
  handler.leave_subsection();
}

void declare_entries(dealii::ParameterHandler& handler) {
  for (Entry const& entry : case_schema())
    in_section(handler, entry.section(), [&] {
      handler.declare_entry(entry.name(), entry.standard, EntryPattern(entry), entry.description);
    });
}

void set_entry(dealii::ParameterHandler& handler, std::string_view path, std::string const& text) {
  in_section(handler, section_of(path), [&] { handler.set(std::string(name_of(path)), text); });
}

CaseText collect(dealii::ParameterHandler& handler, std::string const& name) {
  CaseText all;
  for (Entry const& entry : case_schema())
    in_section(handler, entry.section(), [&] {
      all[entry.path] = {.text = handler.get(entry.name()), .where = name, .is_given = false};
    });
  return all;
}

/// `Section/Entry=value` from the command line.
PlacedValue parse_override(std::string const& written) {
  check_is_text(written, "--set");
  auto const equals = written.find('=');
  VALIDATE(
      equals != std::string::npos,
      fmt::format("--set '{}': has no '=' (an override is 'Section/Entry=value'). Add the value?",
                  quote(written)));
  auto const trim = [](std::string const& text) {
    auto const first = text.find_first_not_of(' ');
    return first == std::string::npos ? std::string()
                                      : text.substr(first, text.find_last_not_of(' ') - first + 1);
  };
  return {trim(written.substr(0, equals)), trim(written.substr(equals + 1)), "--set"};
}

std::vector<PlacedValue> parse_overrides(std::span<std::string const> written) {
  std::vector<PlacedValue> late;
  for (std::string const& override_text : written)
    late.push_back(parse_override(override_text));
  return late;
}

bool is_json(std::filesystem::path const& file) {
  return file.extension() == ".json";
}

/// Both readers on one text: the scanners refuse in our words, with lines; ParameterHandler has the
/// last word.
CaseText read_text(std::string const& text, std::filesystem::path const& file,
                   std::span<PlacedValue const> late) {
  std::string const name = file.string();
  std::vector<Assignment> const written =
      is_json(file) ? scan_json(text, name) : scan_prm(text, name);
  VALIDATE(
      !written.empty(),
      fmt::format("{}: sets no entry (a case sets at least its Title). Is this the right file?",
                  name));
  for (PlacedValue const& value : late)
    check_assignment(value.where, value.path, value.text);
  try {
    dealii::ParameterHandler handler;
    declare_entries(handler);
    if (is_json(file))
      for (Assignment const& entry : written)
        set_entry(handler, entry.path, entry.text);
    else
      handler.parse_input_from_string(text);
    for (PlacedValue const& entry : late)
      set_entry(handler, entry.path, entry.text);
    CaseText all = collect(handler, name);
    for (Assignment const& entry : written) {
      all[entry.path].where = fmt::format("{}:{}", name, entry.line);
      all[entry.path].is_given = true;
    }
    for (PlacedValue const& entry : late) {
      all[entry.path].where = entry.where;
      all[entry.path].is_given = true;
    }
    return all;
  } catch (dealii::ExceptionBase const& problem) {
    std::ostringstream said;
    problem.print_info(said);
    std::string line = said.str();
    for (char& c : line)
      if (c == '\n')
        c = ' ';
    throw dem::InvalidInput(
        fmt::format("{}: cannot be read ({}). Compare it with: presscheck defaults?", name, line));
  }
}

std::string read_whole(std::filesystem::path const& file) {
  std::string const name = file.string();
  std::error_code unreadable;
  auto const status = std::filesystem::status(file, unreadable);
  VALIDATE(std::filesystem::exists(status),
           fmt::format("{}: does not exist (no such case file). Is it misspelt?", name));
  VALIDATE(!std::filesystem::is_directory(status),
           fmt::format("{}: is a folder (a case is a .prm or .json file). Did you mean {}?", name,
                       (file / "case.prm").string()));
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  // An empty file leaves the fail bit on `text`; that is for the scanners to say.
  VALIDATE(in.is_open() && !in.bad(), fmt::format("{}: cannot be read. May you open it?", name));
  return std::move(text).str();
}

/// deal.II's readers know neither the byte order mark nor the line ends of other systems.
std::string normalise(std::string text) {
  if (text.starts_with("\xef\xbb\xbf"))
    text.erase(0, 3);
  std::erase(text, '\r');
  return text;
}

} // namespace

Case read_case(std::filesystem::path const& file, std::span<std::string const> overrides) {
  return parse_case(read_whole(file), file, overrides);
}

Case read_case_with(std::filesystem::path const& file, std::span<PlacedValue const> values) {
  return build_case(read_text(normalise(read_whole(file)), file, values), file);
}

Case parse_case(std::string const& prm_text, std::filesystem::path const& name,
                std::span<std::string const> overrides) {
  return build_case(read_text(normalise(prm_text), name, parse_overrides(overrides)), name);
}

std::string describe_entries(DefaultsFormat format) {
  Case const standard = parse_case("set Mode = rigid\n", "default.prm");
  std::map<std::string, std::string> used;
  for (Assignment const& entry : scan_prm(standard.resolved_text, "default.prm"))
    used[entry.path] = entry.text;
  return format == DefaultsFormat::json ? print_annotated_json(used) : print_annotated_prm(used);
}

} // namespace coupling
