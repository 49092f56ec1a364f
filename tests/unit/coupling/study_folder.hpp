#pragma once

#include "coupling/study/study_plan.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <string>

/// A folder with a tiny case, a table of set-ups, results of them, and a study file.
class StudyFolder : public testing::Test {
protected:
  StudyFolder() {
    auto const tiny = support::bytes_of(PRESSCHECK_SOURCE_DIR "/tests/regression/tiny/case.prm");
    support::put_bytes(folder_ / "case.prm", tiny);
    support::put_bytes(folder_ / "settings.csv",
                       "setup,Powder/Component 1/Young's modulus+Powder/Component 2/Young's "
                       "modulus,Tooling/Young's modulus,Powder/Component 2/Size classes,(why)\n"
                       "soft,20 MPa,160 MPa,1 mm: 100 %,a\n"
                       "mid,25 MPa,200 MPa,1 mm: 100 %,b\n"
                       "hard,30 MPa,240 MPa,1.2 mm: 100 %,c\n"
                       "odd,35 MPa,200 MPa,1.2 mm: 100 %,d\n");
    support::put_bytes(folder_ / "results.csv", "setup,code,max_force [kN],porosity [%]\n"
                                                "soft,A,1,30\nmid,A,2,31\nhard,A,3,32\n"
                                                "soft,B,1.5,33\nmid,B,2.5,34\n");
  }

  coupling::study::StudyPlan plan(std::string const& text) {
    support::put_bytes(folder_ / "study.prm", text);
    return coupling::study::plan_study(coupling::study::read_study(folder_ / "study.prm"));
  }

  /// The message without the folder.
  std::string refusal(std::string const& text) {
    try {
      plan(text);
      return "accepted";
    } catch (dem::InvalidInput const& problem) {
      return without_folder(problem.what());
    }
  }

  std::string without_folder(std::string message) {
    auto const head = folder_.path().string() + "/";
    for (auto at = message.find(head); at != std::string::npos; at = message.find(head))
      message.erase(at, head.size());
    return message;
  }

  static std::string factor_E(std::string const& rest = "set Low = 20 MPa\nset High = 30 MPa\n") {
    return "subsection Factor 1\nset Name = E\nset Entries = Powder/Component 1/Young's modulus + "
           "Powder/Component 2/Young's modulus + 8 x Tooling/Young's modulus\n" +
           rest + "end\n";
  }

  static std::string factor_CED(std::string const& rest = "set Low = 2e5 J/m^3\nset High = 5e5 "
                                                          "J/m^3\n") {
    return "subsection Factor 2\nset Name = CED\nset Entries = Contact/Particle-particle/Cohesion "
           "energy density\n" +
           rest + "end\n";
  }

  static std::string response(std::string const& rest = "") {
    return "subsection Response 1\nset Name = F\nset Quantity = max_force_N\n" + rest + "end\n";
  }

  static std::string design(std::string const& entries) {
    return "set Case = case.prm\nsubsection Design\n" + entries + "end\n";
  }

  support::ScratchFolder folder_;
};
