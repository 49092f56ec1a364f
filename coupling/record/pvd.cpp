#include "coupling/record/atomic_file.hpp"
#include "coupling/record/vtu.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <charconv>
#include <sstream>
#include <string_view>

namespace coupling {
namespace {

/// The text between `before` and the next quote; empty if it is not there.
std::string_view quoted_after(std::string_view line, std::string_view before) {
  auto const start = line.find(before);
  if (start == std::string_view::npos)
    return {};
  line.remove_prefix(start + before.size());
  return line.substr(0, line.find('"'));
}

} // namespace

PvdSeries::PvdSeries(std::filesystem::path file, double time) : file_(std::move(file)) {
  if (!std::filesystem::exists(file_))
    return;
  std::istringstream lines(read_file(file_));
  for (std::string line; std::getline(lines, line);) {
    if (line.find("<DataSet") == std::string::npos)
      continue;
    auto const at = quoted_after(line, "timestep=\"");
    Entry entry{0.0, std::string(quoted_after(line, "file=\""))};
    auto const [end, error] = std::from_chars(at.data(), at.data() + at.size(), entry.time);
    VALIDATE(error == std::errc() && end == at.data() + at.size() && !entry.vtu.empty(),
             fmt::format("{}: the entry '{}' cannot be understood. Was it edited?", file_.string(),
                         line));
    if (entry.time <= time)
      entries_.push_back(std::move(entry));
  }
}

void PvdSeries::add(double time, std::string const& vtu) {
  EXPECT(vtu.find_first_of("<>&\"") == std::string::npos);
  entries_.push_back({time, vtu});
  std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (auto const& entry : entries_)
    xml += fmt::format("    <DataSet timestep=\"{}\" file=\"{}\"/>\n", shortest(entry.time),
                       entry.vtu);
  write_file(file_, xml + "  </Collection>\n</VTKFile>\n");
}

} // namespace coupling
