#include "tests/browser/chromium.hpp"

#include "coupling/record/atomic_file.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

namespace browser {
namespace {

/// A folder that lives as long as the visit: chromium's profile and its output.
struct VisitFolder {
  std::filesystem::path path = [] {
    auto name = (std::filesystem::temp_directory_path() / "presscheck-browser-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("cannot create " + name);
    return name;
  }();
  ~VisitFolder() {
    std::error_code ignored; // chromium's children may still be closing their files
    std::filesystem::remove_all(path, ignored);
  }
};

std::string with_script(std::string page, std::string const& script) {
  auto const end = page.rfind("</body>");
  if (end == std::string::npos)
    throw std::runtime_error("the page has no </body>");
  return page.insert(end, "<script>\n" + script + "\n</script>\n");
}

std::string console_lines(std::string const& log) {
  std::istringstream lines(log);
  std::string found;
  for (std::string line; std::getline(lines, line);)
    if (line.find(":CONSOLE") != std::string::npos)
      found += line + "\n";
  return found;
}

void replace_all(std::string& text, std::string const& from, std::string const& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

} // namespace

Page open(std::filesystem::path const& file, std::string const& script) {
  VisitFolder const visit;
  auto const page = visit.path / "page.html";
  coupling::write_file(page, with_script(coupling::read_file(file), script));
  auto const dom = visit.path / "dom.html";
  auto const log = visit.path / "log.txt";
  // SwiftShader draws WebGL on the processor. The resolver rule and the dead proxy cut every way
  // out.
  auto const command =
      fmt::format("timeout 120 chromium --headless=new --no-sandbox --enable-unsafe-swiftshader "
                  "--use-angle=swiftshader "
                  "--host-resolver-rules='MAP * ~NOTFOUND' --proxy-server=127.0.0.1:9 "
                  "--disable-background-networking "
                  "--enable-logging=stderr --v=0 --window-size=1366,900 --user-data-dir='{}' "
                  "--virtual-time-budget=5000 "
                  "--dump-dom 'file://{}' >'{}' 2>'{}'",
                  (visit.path / "profile").string(), page.string(), dom.string(), log.string());
  int const status = std::system(command.c_str());
  if (status != 0)
    throw std::runtime_error(
        fmt::format("chromium failed with status {} (Debian package chromium):\n{}", status,
                    coupling::read_file(log)));
  return {coupling::read_file(dom), console_lines(coupling::read_file(log))};
}

std::string Page::note(std::string const& name) const {
  auto const tag = dom.substr(0, dom.find("<head>"));
  auto const key = " data-" + name + "=\"";
  auto const at = tag.find(key);
  if (at == std::string::npos)
    return "(absent)";
  auto const from = at + key.size();
  auto value = tag.substr(from, tag.find('"', from) - from);
  replace_all(value, "&lt;", "<");
  replace_all(value, "&gt;", ">");
  replace_all(value, "&quot;", "\"");
  replace_all(value, "&amp;", "&");
  return value;
}

double Page::number(std::string const& name) const {
  return std::stod(note(name));
}

} // namespace browser
