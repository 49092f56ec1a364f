#include "coupling/study/results_data.hpp"

#include "coupling/compare/value_table.hpp"
#include "coupling/nearest_name.hpp"
#include "coupling/quote.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/csv.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace coupling::study {
namespace {

/// A table of results: its numbers, and the words that rows are chosen by.
class ResultsTable {
public:
  explicit ResultsTable(StudyFile const& study)
      : study_(study), name_(study.design.results.string()), rows_(read_value_table(name_)),
        lines_(split_csv(read_file(name_), name_)) {
    setup_ = column("setup", "Design/Results");
    auto const& header = lines_.front().fields;
    if (auto const found = std::ranges::find(header, "replicate"); found != header.end())
      replicate_ = static_cast<std::size_t>(found - header.begin());
    if (!replicate_ && study.design.replicates > 1)
      study.text.refuse("Design/Replicates", fmt::format("cannot be told apart in {} (it has no "
                                                         "column 'replicate'). Write 1?",
                                                         name_));
    for (auto const& filter : study.design.filter)
      filter_.emplace_back(column(filter.column, "Design/Results filter"), filter.text);
  }

  /// The numbers of a run.
  StudyValues of(StudyRun const& run) const {
    std::optional<std::size_t> found;
    for (std::size_t k = 1; k < lines_.size(); ++k) {
      if (!is_of(lines_[k].fields, run))
        continue;
      VALIDATE(!found,
               fmt::format("{}:{}: is a second row of '{}' (first on line {}). Which one is "
                           "meant? Set 'Design/Results filter'?",
                           name_, lines_[k].number, run.id, lines_[*found].number));
      found = k;
    }
    VALIDATE(found.has_value(),
             fmt::format("{}: has no row of '{}'{} ({} runs it). Add the row, or "
                         "leave out the run?",
                         name_, run.setup, filter_text(run), run.where));
    StudyValues values;
    for (auto const& value : rows_[*found - 1].values)
      values[value.name] = {value.value, value.unit};
    for (auto const& response : study_.responses)
      VALIDATE(values.contains(response.quantity),
               fmt::format("{}:{}: has no {} (response '{}' of {} needs it). Fill the cell, or "
                           "leave out the run?",
                           name_, lines_[*found].number, response.quantity, response.name,
                           response.where));
    return values;
  }

private:
  std::size_t column(std::string const& name, std::string const& entry) const {
    auto const& header = lines_.front().fields;
    auto const found = std::ranges::find(header, name);
    if (found == header.end())
      study_.text.refuse(entry,
                         fmt::format("the table {} has no column '{}'.{}", name_, quote(name),
                                     did_you_mean(name, header, "Which one is meant?")));
    return static_cast<std::size_t>(found - header.begin());
  }

  bool is_of(std::vector<std::string> const& fields, StudyRun const& run) const {
    bool const passes =
        std::ranges::all_of(filter_, [&](auto const& f) { return fields[f.first] == f.second; });
    return passes && fields[setup_] == run.setup &&
           (!replicate_ || fields[*replicate_] == fmt::format("{}", run.replicate));
  }

  std::string filter_text(StudyRun const& run) const {
    std::string text = run.replicate > 1 ? fmt::format(", replicate {}", run.replicate) : "";
    for (auto const& filter : study_.design.filter)
      text += fmt::format(", {} = {}", filter.column, filter.text);
    return text;
  }

  StudyFile const& study_;
  std::string name_;
  std::vector<ValueRow> rows_;
  std::vector<CsvLine> lines_; // the header, then one a row
  std::size_t setup_ = 0;
  std::optional<std::size_t> replicate_;
  std::vector<std::pair<std::size_t, std::string>> filter_; // column, text
};

} // namespace

std::vector<StudyValues> read_results(StudyPlan const& plan) {
  ResultsTable const table(plan.study);
  std::vector<StudyValues> values;
  for (auto const& run : plan.runs)
    values.push_back(table.of(run));
  return values;
}

} // namespace coupling::study
