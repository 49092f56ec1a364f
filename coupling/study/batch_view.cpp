#include "coupling/study/batch_view.hpp"

#include <fmt/format.h>

#include <ostream>

namespace coupling::study {
namespace {

constexpr auto pause = std::chrono::milliseconds(500);
constexpr std::size_t most_named = 3; // running runs on the line

std::string time_left(double seconds) {
  return seconds < 0.0 ? "" : fmt::format(", {} left", write_duration(seconds));
}

} // namespace

bool BatchView::is_due() const {
  return style_ == ProgressStyle::terminal && std::chrono::steady_clock::now() - last_ >= pause;
}

void BatchView::show(BatchReading const& now, std::list<BatchChild> const& children,
                     BatchFolder const& folder) {
  last_ = std::chrono::steady_clock::now();
  std::string named;
  std::size_t n = 0;
  for (auto const& child : children) {
    if (n++ == most_named)
      break;
    named += fmt::format("{}{} {:.0f} %", named.empty() ? " (" : ", ", child.run().id,
                         100.0 * logged_fraction(folder.log(child.run().id)));
  }
  named += named.empty() ? "" : n > most_named ? ", ...)" : ")";
  out_ << fmt::format("\r{} of {} done, {} running{}, {} waiting, {} failed{}\033[K", now.n_done,
                      now.n_runs, children.size() + now.n_elsewhere, named, now.n_waiting,
                      now.n_failed, time_left(now.seconds_left))
       << std::flush;
  line_is_open_ = true;
}

void BatchView::tell_end(BatchReading const& now, std::string const& id,
                         std::string const& sentence) {
  bool const is_failure = !sentence.starts_with("done");
  if (style_ == ProgressStyle::silent || (style_ == ProgressStyle::terminal && !is_failure))
    return;
  finish();
  out_ << fmt::format("{} of {} done, {} failed{}: {} {}\n", now.n_done, now.n_runs, now.n_failed,
                      time_left(now.seconds_left), id, sentence)
       << std::flush;
}

void BatchView::finish() {
  if (line_is_open_)
    out_ << '\n' << std::flush;
  line_is_open_ = false;
}

} // namespace coupling::study
