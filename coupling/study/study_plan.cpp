#include "coupling/study/study_plan.hpp"

#include "coupling/case_file.hpp"
#include "coupling/record/checksum.hpp"
#include "coupling/study/study_points.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>

namespace coupling::study {
namespace {

/// A name as a folder may bear it.
std::string folder_name(std::string name) {
  auto const is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.' || c == '+';
  };
  std::ranges::replace_if(
      name, [&](char c) { return !is_plain(static_cast<unsigned char>(c)); }, '_');
  // A folder must be neither hidden nor taken for an option.
  if (name.starts_with('.') || name.starts_with('-'))
    name[0] = '_';
  return name;
}

Case read_point(StudyFile const& study, std::vector<PlacedValue> values) {
  values.insert(values.begin(), study.common.begin(), study.common.end());
  return read_case_with(study.case_file, values);
}

/// The runs of one point: the packing seed of each is one more than that of the one before.
std::vector<StudyRun> runs_of(StudyFile const& study, StudyPoint const& point, int replicates,
                              std::string const& replicates_entry) {
  std::vector<StudyRun> runs;
  auto const first = read_point(study, point.values);
  if (replicates > 1 && first.powder.fill_method != FillMethod::random)
    study.text.refuse(replicates_entry,
                      fmt::format("makes {} runs of '{}' that are all the same (Powder/Fill method "
                                  "is not random, so no packing seed is read). Write 1?",
                                  replicates, point.name));
  for (int r = 1; r <= replicates; ++r) {
    auto const name = folder_name(point.name);
    StudyRun run{.id = r == 1 ? name : fmt::format("{}_r{}", name, r),
                 .setup = point.name,
                 .where = point.where,
                 .replicate = r,
                 .natural = point.natural};
    if (r == 1)
      run.case_text = first.resolved_text;
    else {
      auto values = point.values;
      std::erase_if(values, [](auto const& v) { return v.path == "Powder/Packing seed"; });
      values.push_back({"Powder/Packing seed",
                        fmt::format("{}", first.powder.seed + static_cast<std::uint64_t>(r - 1)),
                        study.text.where(replicates_entry)});
      run.case_text = read_point(study, values).resolved_text;
    }
    run.hash = hash_of(run.case_text);
    runs.push_back(std::move(run));
  }
  return runs;
}

void check_names(std::vector<StudyRun> const& runs) {
  std::map<std::string, StudyRun const*> by_id;
  for (auto const& run : runs) {
    auto const [first, is_new] = by_id.emplace(run.id, &run);
    VALIDATE(is_new,
             fmt::format("{}: run '{}' has the name of another one, '{}' ({}): its folder would be "
                         "'{}', too. Rename one?",
                         run.where, run.setup, first->second->setup, first->second->where, run.id));
  }
}

} // namespace

std::string hash_of(std::string_view text) {
  Checksum sum;
  sum.add(std::as_bytes(std::span(text)));
  return fmt::format("{:016x}", sum.value());
}

StudyPlan plan_study(StudyFile study) {
  StudyPlan plan{std::move(study), {}};
  for (auto const& point : points_of(plan.study)) {
    auto const replicates = point.times * plan.study.design.replicates;
    auto const* const entry = point.times > 1 ? "Design/Centre runs" : "Design/Replicates";
    std::ranges::move(runs_of(plan.study, point, replicates, entry), std::back_inserter(plan.runs));
  }
  check_names(plan.runs);
  return plan;
}

std::vector<StudyRun> runs_at(StudyPlan const& plan, std::string const& label,
                              std::span<double const> natural, int replicates) {
  StudyFile const& study = plan.study;
  EXPECT(natural.size() == study.factors.size());
  std::vector<double> rounded;
  for (std::size_t f = 0; f < natural.size(); ++f)
    rounded.push_back(study.factors[f].rounded(natural[f]));
  auto point = point_at(study, rounded);
  point.name = label + "_" + point.name;
  auto runs = runs_of(study, point, replicates, "Calibration/Validation replicates");
  for (auto& run : runs)
    run.is_validation = true;
  return runs;
}

} // namespace coupling::study
