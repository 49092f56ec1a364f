#include "continuum/tool/gmsh_session.hpp"

#include "continuum/errors.hpp"

#include <gmsh.h>

namespace continuum {

namespace {
class GmshSession {
public:
  GmshSession() {
    gmsh::initialize(0, nullptr, /*readConfigFiles=*/false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1); // the same mesh on every machine
  }
  ~GmshSession() { gmsh::finalize(); }
  GmshSession(GmshSession const&) = delete;
  GmshSession& operator=(GmshSession const&) = delete;
};

[[noreturn]] void refuse(std::filesystem::path const& file, std::string const& message) {
  throw InvalidInput(file.string() + ": gmsh cannot use it (" + message +
                     "). Does gmsh's own window open it?");
}
} // namespace

void with_gmsh(std::filesystem::path const& file, std::function<void()> const& work) {
  GmshSession const session;
  try {
    work();
  } catch (InvalidInput const&) {
    throw;
  } catch (std::exception const& error) {
    refuse(file, error.what());
  } catch (std::string const& error) { // what some versions throw
    refuse(file, error);
  }
}

} // namespace continuum
