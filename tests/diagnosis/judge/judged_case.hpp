#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace judging {

struct Truth {
  std::string kind; ///< clean, single, double, unknown
  bool has_all_gauges = false;
  std::set<std::string> causes;
  double size = 0.0;                ///< of a single effect [SI]
  std::optional<double> lambda;     ///< predicted detectability
  std::optional<double> faintest;   ///< least lambda of its effects, each alone
  std::optional<double> separation; ///< Delta to the nearest single rival
};

struct SizeInterval {
  double value, low, high;
};

/// On held-out runs, all channels together.
struct Gain {
  double before, after;             ///< root mean square error [standard uncertainties]
  std::optional<double> of_placebo; ///< what the best wrong cause leaves
  double elpd, elpd_error;          ///< difference of the log scores, and its standard error
  double coverage;                  ///< share of the rows inside their 95 % band
};

struct Answer {
  std::string verdict; ///< consistent, named, undecided, unknown
  bool is_incomplete = false;
  std::set<std::string> claim;                 ///< the named causes, or the group
  double probability = 0.0;                    ///< of the named set: the least of its members'
  std::optional<SizeInterval> size;            ///< of the first named cause
  std::optional<double> p_omnibus, p_targeted; ///< of the alarm's two tests
  std::optional<Gain> gain;
};

struct JudgedCase {
  std::string name;
  Truth truth;
  Answer answer;

  bool is_detected() const { return answer.verdict != "consistent"; }
  bool is_named() const { return answer.verdict == "named"; }
  bool has_truth() const; ///< all hidden causes are in the claim
  bool is_unique() const; ///< one name, and nothing left over
  bool is_right_alone() const { return is_unique() && answer.claim == truth.causes; }
  /// A name or a group without any hidden cause.
  bool is_wrong() const;
  /// A name that is not hidden. A group is no claim that all of it is there.
  bool has_spurious() const;
};

/// Named are the causes of probability 0.9 and more, else the first of the list.
Answer read_answer(std::filesystem::path const& diagnosis);
Truth read_truth(std::filesystem::path const& truth);

/// Every folder NAME in it with sealed/truth.json, and its diagnosis/diagnosis.json, by name.
/// @throws std::runtime_error for a missing or unreadable file: no answer is no excuse
std::vector<JudgedCase> read_cases(std::filesystem::path const& folder);

} // namespace judging
