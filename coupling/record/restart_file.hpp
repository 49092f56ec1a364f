#pragma once

#include "coupling/record/h5.hpp"

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

/// Restart files: everything a run needs to go on to the same bits.
///
///   StateWriter write(file, header);            StateReader read(file);
///   dem::visit_state(world, write);             dem::visit_state(world, read);
///   cycle.visit_state(write);                   cycle.visit_state(read);
///   write.commit();                             read.finish();
namespace coupling {

/// Which run a state belongs to and where in it.
struct RestartHeader {
  std::string program_version = {};
  std::string case_text = {}; ///< the full case as understood, .prm
  std::string stage;          ///< the stage that is running, or has just ended
  std::uint64_t step = 0;
  double time = 0.0; ///< [s], simulated
};

/// A visitor that stores each field it is shown: any type that H5Writer writes.
class StateWriter {
public:
  /// @throws dem::InvalidInput if no file can be created there
  StateWriter(std::filesystem::path const& file, RestartHeader const& header);

  /// @throws dem::PhysicsGuard if a value of `grains/` is not finite: such a state must not replace
  /// a good one
  template <class T> void operator()(std::string const& name, T const& value) {
    check_finite(name, value);
    file_.write("state/" + name, value);
  }

  /// @throws WriteFailed; an earlier file of this name then still stands
  void commit() { file_.commit(); }

private:
  template <class T> void check_finite(std::string const&, T const&) {}
  void check_finite(std::string const& name, std::vector<double> const& values);
  void check_finite(std::string const& name, std::vector<dem::Vec3> const& values);

  H5Writer file_;
  std::string label_;
};

/// A visitor that restores each field it is shown.
class StateReader {
public:
  /// @throws dem::InvalidInput if the file is missing, damaged, of another format, or its grains
  /// are no grains
  explicit StateReader(std::filesystem::path const& file);

  RestartHeader const& header() const { return header_; }

  /// @throws dem::InvalidInput if the field is missing or has another type
  template <class T> void operator()(std::string const& name, T& value) {
    file_.read("state/" + name, value);
    unread_.erase("state/" + name);
  }

  /// @throws dem::InvalidInput if the file holds fields that nobody asked for: it is of another
  /// version or case
  void finish() const;

private:
  H5Reader file_;
  RestartHeader header_;
  std::set<std::string> unread_;
};

/// `restart_<step>.h5` and `restart_stage_<stage>.h5` in `folder`.
std::filesystem::path rolling_restart(std::filesystem::path const& folder, std::uint64_t step);
std::filesystem::path stage_restart(std::filesystem::path const& folder, std::string const& stage);

/// Deletes all but the `n_kept` newest rolling restarts. Call after a commit, never before.
void prune_restarts(std::filesystem::path const& folder, std::size_t n_kept = 2);

struct FoundRestart {
  std::filesystem::path file;
  RestartHeader header;
  std::vector<std::string>
      refused; ///< why other restart files of the folder were passed over, one message each
};

/// The restart file of `folder` that is farthest in the run and whole.
/// @throws dem::InvalidInput if there is none, with the reason for each that was refused
FoundRestart newest_restart(std::filesystem::path const& folder);

} // namespace coupling
