#include "coupling/study/study_vocabulary.hpp"

#include "coupling/case_value.hpp"
#include "coupling/nearest_name.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

namespace coupling::study {
namespace {

using enum EntryKind;

constexpr Range any{};
constexpr Range above_zero{.low = 0.0, .is_low_allowed = false};
constexpr Range count_from(double low, double high) {
  return {.low = low, .high = high};
}

/// A line of any length: `file` is the kind whose text is not looked at.
Entry words(std::string path, std::string standard, std::string description) {
  return {std::move(path),       file, Physical::ratio, std::move(standard), any, "",
          std::move(description)};
}

Entry number(std::string path, std::string standard, Range range, std::string description) {
  return {std::move(path), count, Physical::ratio,       std::move(standard),
          range,           "",    std::move(description)};
}

Entry quantity_of(std::string path, Physical physical, std::string standard, Range range,
                  std::string description) {
  return {std::move(path),       quantity, physical, std::move(standard), range, "",
          std::move(description)};
}

Entry one_of(std::string path, std::string standard, std::string choices, std::string description) {
  return {std::move(path),       choice, Physical::ratio,
          std::move(standard),   any,    std::move(choices),
          std::move(description)};
}

std::vector<Entry> design_entries() {
  return {
      words("Title", "", "One line that heads the report."),
      words("Case", "", "Case file that the runs change."),
      one_of("Model", "quadratic", "linear | interactions | quadratic",
             "Terms of the response surfaces; each holds those before it."),
      one_of("Design/Kind", "table", "table | full_factorial | central_composite | latin_hypercube",
             "Where the runs come from."),
      words("Design/Table", "", "Table of set-ups; empty: settings.csv beside the case."),
      words("Design/Rows", "", "Names of rows, with commas; empty: all."),
      words("Design/Results", "", "Table of results that is read instead of running anything."),
      words("Design/Results filter", "", "column = text, with commas: rows of Results that count."),
      number("Design/Replicates", "1", count_from(1, 1000),
             "Runs of each point, with packing seeds that follow each other."),
      number("Design/Runs", "20", count_from(2, 1e5), "Runs of a Latin hypercube."),
      number("Design/Centre runs", "1", count_from(0, 1000),
             "Runs at the centre of a central composite design."),
      one_of("Design/Axial points", "face_centred", "face_centred | circumscribed | inscribed",
             "Where the axial points of a central composite design stand."),
      number("Design/Seed", "1", count_from(0, 9e15), "Seed of a Latin hypercube."),
  };
}

std::vector<Entry> part_entries() {
  return {
      words("Factor #/Name", "", "Short name, such as E."),
      words("Factor #/Entries", "", "PATH + 0.8 x PATH + PATH as {}: 100 %: what the factor sets."),
      words("Factor #/Low", "", "Value that is coded -1."),
      words("Factor #/High", "", "Value that is coded 1."),
      words("Factor #/Levels", "3", "Full factorial: how many levels, or the levels themselves."),
      words("Response #/Name", "", "Short name, such as F."),
      words("Response #/Quantity", "", "Key of summary.json, or column of Results."),
      words("Response #/Target", "", "Value that calibration aims at."),
      words("Response #/Target uncertainty", "", "Standard uncertainty of the target."),
      words("Response #/Observed", "",
            "Measured value to stand beside; calibration aims at Target."),
      quantity_of("Response #/Reference scale", Physical::ratio, "1", above_zero,
                  "Published values times this stand beside the response."),
      words("Calibration/Held", "", "name = value, with commas: factors that are not fitted."),
      one_of("Calibration/Validation", "false", "true | false", "Run the calibrated point."),
      number("Calibration/Validation replicates", "1", count_from(1, 1000),
             "Packing seeds of the calibrated point."),
      words("Extrapolation/Factor", "", "Factor that is a size."),
      words("Extrapolation/Value", "", "Its value that cannot be run."),
      words("Extrapolation/Responses", "", "Names of responses, with commas; empty: all."),
      words("Extrapolation/Forms", "linear, quadratic, logarithmic, power",
            "Curves that compete, with commas; packing_model (de Larrard) is one, too."),
      quantity_of("Extrapolation/Fine share", Physical::ratio, "",
                  {.low = 0.0, .high = 1.0, .is_low_allowed = false, .is_high_allowed = false},
                  "packing_model: share of the grains of size Factor in the solid volume."),
      quantity_of("Extrapolation/Compaction index", Physical::ratio, "9", above_zero,
                  "packing_model: K; 4.1 poured, 4.75 rodded, 9 vibrated and pressed."),
      {"Extrapolation/Coarse sizes", size_classes, Physical::length, "", above_zero, "",
       "packing_model: the other grains; empty: one size, which is fitted."},
      words("Cost/Factor", "",
            "Factor that the cost is a power of, or the word grains: their number."),
      words("Cost/Predict at", "",
            "Its values, with commas, at which a run's time and memory are foretold; empty: "
            "Extrapolation/Value where the factor is the same."),
      words("Reference/Tables", "", "Tables of published values, with commas."),
      words("Reference/Rows", "",
            "setup = row, with commas: set-ups that the tables call otherwise."),
  };
}

/// `Factor 12/Name` -> `Factor #/Name`.
std::string generic(std::string_view path) {
  for (std::string_view const kind : {"Factor ", "Response "}) {
    if (!path.starts_with(kind))
      continue;
    auto const end = path.find_first_not_of("0123456789", kind.size());
    auto const digits = std::min(end, path.size()) - kind.size();
    if (digits == 0 || digits > 3 || path[kind.size()] == '0')
      continue;
    return fmt::format("{}#{}", kind, end == std::string_view::npos ? "" : path.substr(end));
  }
  return std::string(path);
}

/// The part of a path below `Case entries`; a path of another section is none.
std::string_view below_common(std::string_view path) {
  return path.starts_with(common_section) && path.size() > common_section.size() &&
                 path[common_section.size()] == '/'
             ? path.substr(common_section.size() + 1)
             : std::string_view{};
}

std::vector<std::string> known_sections() {
  std::set<std::string> sections{std::string(common_section)};
  for (Entry const& entry : study_schema())
    if (!entry.section().empty())
      sections.insert(entry.section());
  return {sections.begin(), sections.end()};
}

/// Names that `path` may be a slip of: the rows with its own section's number in place.
std::vector<std::string> known_entries(std::string_view path) {
  std::vector<std::string> names;
  auto const section = section_of(path);
  auto const own = generic(section);
  for (Entry const& entry : study_schema())
    names.push_back(entry.section() == own && !own.empty()
                        ? fmt::format("{}/{}", section, entry.name())
                        : entry.path);
  return names;
}

} // namespace

std::span<Entry const> study_schema() {
  static std::vector<Entry> const entries = [] {
    auto all = design_entries();
    for (auto& entry : part_entries())
      all.push_back(std::move(entry));
    return all;
  }();
  return entries;
}

Entry const* find_study_entry(std::string_view path) {
  auto const wanted = generic(path);
  auto const row = std::ranges::find(study_schema(), wanted, &Entry::path);
  return row == study_schema().end() ? nullptr : &*row;
}

void StudyVocabulary::check_section(std::string const& where, std::string_view path) const {
  if (auto const part = below_common(path); !part.empty()) {
    VALIDATE(is_section(part), fmt::format("{}: subsection {}: is no section of a case.{}", where,
                                           quote(part), suggest_section(part)));
    return;
  }
  auto const known = known_sections();
  VALIDATE(std::ranges::count(known, generic(path)) > 0 && path.find('#') == std::string::npos,
           fmt::format("{}: subsection {}: is no section of a study (there are: {}).{}", where,
                       quote(path), fmt::join(known, ", "),
                       did_you_mean(path, known, "Which of them is meant?")));
}

void StudyVocabulary::check_entry(std::string const& where, std::string_view path,
                                  std::string_view text) const {
  if (auto const part = below_common(path); !part.empty())
    return check_assignment(where, part, text);
  Entry const* const entry =
      path.find('#') == std::string_view::npos ? find_study_entry(path) : nullptr;
  if (entry == nullptr)
    refuse_entry(where, path, text,
                 "is no entry of a study." + did_you_mean(path, known_entries(path),
                                                          "What does presscheck study --entries "
                                                          "say?"));
  try {
    check_value(*entry, text);
  } catch (dem::InvalidInput const& problem) {
    refuse_entry(where, path, text, problem.what());
  }
}

StudyText::StudyText(std::string const& text, std::string name) : name_(std::move(name)) {
  for (auto& entry : scan_prm_lines(text, name_, StudyVocabulary()))
    entries_.emplace(entry.path, entry);
  VALIDATE(!entries_.empty(),
           name_ + ": sets no entry (a study names at least its case). Is this the right file?");
}

std::string StudyText::text(std::string const& path) const {
  auto const found = entries_.find(path);
  return found == entries_.end() ? find_study_entry(path)->standard : found->second.text;
}

long StudyText::count(std::string const& path) const {
  return static_cast<long>(parse_count(*find_study_entry(path), text(path)));
}

std::string StudyText::where(std::string const& path) const {
  auto const found = entries_.find(path);
  return found == entries_.end() ? name_ : fmt::format("{}:{}", name_, found->second.line);
}

std::vector<int> StudyText::numbers(std::string const& kind) const {
  std::set<int> found;
  for (auto const& [path, entry] : entries_) {
    int number = 0;
    if (path.starts_with(kind + " ") &&
        std::from_chars(path.data() + kind.size() + 1, path.data() + path.size(), number).ec ==
            std::errc{})
      found.insert(number);
  }
  return {found.begin(), found.end()};
}

std::vector<PlacedValue> StudyText::common() const {
  std::vector<PlacedValue> values;
  for (auto const& [path, entry] : entries_)
    if (auto const part = below_common(path); !part.empty())
      values.push_back({std::string(part), entry.text, where(path)});
  return values;
}

void StudyText::refuse(std::string const& path, std::string_view problem) const {
  refuse_entry(where(path), path, text(path), problem);
}

std::string StudyText::needed(std::string const& path, std::string_view why) const {
  auto written = text(path);
  VALIDATE(!written.empty(), fmt::format("{}: {} is not set ({}). Add 'set {} = ...'?", where(path),
                                         path, why, name_of(path)));
  return written;
}

} // namespace coupling::study
