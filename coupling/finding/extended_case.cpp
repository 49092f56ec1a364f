#include "coupling/finding/extended_case.hpp"

#include "coupling/case_file.hpp"
#include "coupling/case_schema.hpp"
#include "coupling/finding/cause_words.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <map>

namespace coupling::finding {
namespace {

using Values = std::map<std::string, std::string>;

Values values_of(std::string const& resolved_text) {
  Values values;
  for (auto const& one : scan_prm(resolved_text, "case"))
    values[one.path] = one.text;
  return values;
}

/// Cases one after the other, each read back before it counts.
class Extension {
public:
  explicit Extension(Case setup) : now_(std::move(setup)) {}

  Case const& now() const { return now_; }

  /// @param what  "frame_compliance = ..." for the comment
  void add(std::string const& name, CauseEntries const& entries, std::string const& because) {
    if (!entries.obstacle.empty())
      return refuse(name, entries.obstacle);
    std::vector<std::string> overrides;
    for (auto const& one : entries.changes)
      overrides.push_back(one.path + "=" + one.text);
    try {
      Case next = parse_case(now_.resolved_text, now_.file, overrides);
      note(values_of(now_.resolved_text), values_of(next.resolved_text), entries,
           entries.remark.empty() ? because : because + "; " + entries.remark);
      now_ = std::move(next);
    } catch (dem::InvalidInput const& refusal) {
      // "--set" is how the entry came there, which nobody needs to know.
      std::string_view why = refusal.what();
      why.remove_prefix(why.starts_with("--set: ") ? 7 : 0);
      refuse(name, std::string(why));
    }
  }

  ExtendedCase finish(std::vector<std::string> const& head) &&;

private:
  void refuse(std::string const& name, std::string const& why) {
    result_.not_modelled.push_back(
        fmt::format("{} ({}) is not in the extended case: {}", words_of(name), name, why));
  }
  void note(Values const& before, Values const& after, CauseEntries const& entries,
            std::string const& because) {
    for (auto const& one : entries.changes) {
      auto const was = before.find(one.path), is = after.find(one.path);
      std::string const old = was == before.end() ? "" : was->second;
      if (is != after.end() && is->second != old)
        result_.changes.push_back({one.path, old, is->second, because});
    }
  }

  Case now_;
  ExtendedCase result_;
};

/// Puts the reasons above the line of each changed entry, and the head on top.
std::string commented(std::string const& prm, std::vector<ChangedEntry> const& changes,
                      std::vector<std::string> const& head) {
  std::map<int, std::vector<std::string>> notes;
  for (auto const& line : scan_prm(prm, "case"))
    for (auto const& change : changes)
      if (change.path == line.path)
        notes[line.line].push_back(
            fmt::format("# {}{}", change.because,
                        change.before.empty() ? "" : fmt::format("; before: {}", change.before)));
  std::string text;
  for (auto const& one : head)
    text += "# " + one_line(one) + "\n";
  int number = 0;
  for (std::size_t at = 0; at < prm.size();) {
    auto const end = prm.find('\n', at) + 1;
    auto const indent = prm.find_first_not_of(' ', at) - at;
    for (auto const& note : notes[++number])
      text += std::string(indent, ' ') + one_line(note) + "\n";
    text += prm.substr(at, end - at);
    at = end;
  }
  return text;
}

ExtendedCase Extension::finish(std::vector<std::string> const& head) && {
  auto lines = head;
  lines.insert(lines.end(), result_.not_modelled.begin(), result_.not_modelled.end());
  if (result_.changes.empty())
    lines.emplace_back("No entry differs from the case that was diagnosed.");
  result_.text = commented(now_.resolved_text, result_.changes, lines);
  return std::move(result_);
}

ExtendedCase extend(Case const& setup, std::vector<FoundCause> const& causes,
                    std::vector<CalibratedValue> const& calibrated, BedFacts const& facts,
                    std::vector<std::string> const& head) {
  Extension extension(parse_case(setup.resolved_text, setup.file));
  for (auto const& value : calibrated)
    extension.add(value.name, case_entries_of(value, extension.now()), in_words(value));
  for (auto const& cause : causes)
    if (!cause.is_calibrated)
      extension.add(cause.name, case_entries_of(cause, extension.now(), facts), in_words(cause));
  return std::move(extension).finish(head);
}

} // namespace

ExtendedCase extended_case(Case const& setup, std::vector<FoundCause> const& causes,
                           std::vector<CalibratedValue> const& calibrated, BedFacts const& facts) {
  return extend(setup, causes, calibrated, facts,
                {fmt::format("Extended by presscheck {} from {}.", PRESSCHECK_VERSION,
                             setup.file.filename().string())});
}

ExtendedCase extended_case(Case const& setup, Finding const& finding, BedFacts const& facts) {
  std::vector<std::string> head{
      fmt::format("Extended by presscheck {} from {} and the measured data of {}.",
                  PRESSCHECK_VERSION, finding.provenance.case_file, finding.provenance.data_folder),
      "Verdict: " + finding.verdict +
          (finding.is_incomplete ? ", but as it is known the cause does not explain all of it."
                                 : ".")};
  if (finding.verdict == "undecided")
    head.emplace_back("No cause is modelled: these data cannot tell which one it is.");
  if (finding.verdict == "unknown")
    head.emplace_back("No cause is modelled: no known one explains these data.");
  return extend(setup, named_causes(finding), finding.calibrated, facts, head);
}

} // namespace coupling::finding
