// clang-format off
// fuzz-build: coupling/measured/*.cpp
// fuzz-build: coupling/nearest_name.cpp coupling/quantity.cpp coupling/quote.cpp coupling/units.cpp
// fuzz-build: coupling/record/atomic_file.cpp
// fuzz-build: -lfmt
// clang-format on
#include "coupling/measured/read_measured.hpp"
#include "coupling/measured/write_measured.hpp"
#include "dem/expect.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

using namespace coupling::measured;

/// The texts of an input stand between lines of one `%`: measured.json, then its files in the order
/// in which they are asked for; the last one serves all that follow.
class Texts {
public:
  explicit Texts(std::string_view input) : rest_(input) { json_ = next(); }
  std::string_view json() const { return json_; }
  std::string next() {
    auto const end = rest_.find("\n%\n");
    if (end == std::string_view::npos)
      return std::string(rest_);
    std::string text(rest_.substr(0, end + 1));
    rest_.remove_prefix(end + 3);
    return text;
  }

private:
  std::string_view rest_;
  std::string json_;
};

void must(bool condition) {
  if (!condition)
    std::abort();
}

/// Series are as long as their times, times increase, and what is written reads back as the same
/// text.
void check(MeasuredData const& data) {
  must(!data.runs.empty());
  for (auto const& run : data.runs) {
    must(!run.time.empty() && run.rows.size() == run.time.size());
    for (std::size_t k = 1; k < run.time.size(); ++k)
      must(run.time[k] > run.time[k - 1]);
    for (auto const& [channel, values] : run.series)
      must(values.size() == run.time.size() && data.channel(channel) != nullptr);
  }
}

void check_round_trip(MeasuredData data) {
  data.decisions.clear();
  auto const texts = print_measured(data);
  auto again = parse_measured(texts.at("measured.json"), "",
                              [&](std::string const& file) { return texts.at(file); });
  again.decisions.clear();
  must(print_measured(again) == texts);
}

} // namespace

/// Any text is either refused with InvalidInput in one line, or is measured data that holds
/// together.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  Texts texts({reinterpret_cast<char const*>(data), size});
  try {
    auto const read =
        parse_measured(texts.json(), "", [&](std::string const&) { return texts.next(); });
    check(read);
    check_round_trip(read);
  } catch (dem::InvalidInput const& problem) {
    must(std::string_view(problem.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
