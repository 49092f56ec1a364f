#include "coupling/case_setups.hpp"

#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace coupling {
namespace {

/// A folder with a table of setups beside a case.
class SetupTable : public testing::Test {
protected:
  std::vector<std::string> read(std::string const& table, std::string const& name = "a") {
    support::put_bytes(folder_ / "settings.csv", table);
    return setup_overrides(folder_ / "case.prm", name);
  }

  /// The message without the folder.
  std::string refusal(std::string const& table, std::string const& name = "a") {
    try {
      read(table, name);
      return "accepted";
    } catch (dem::InvalidInput const& problem) {
      return std::string(problem.what()).substr(folder_.path().string().size() + 1);
    }
  }

  support::ScratchFolder folder_;
};

TEST_F(SetupTable, BecomeOverridesOfEveryEntryThatSharesTheColumn) {
  EXPECT_EQ(read("# words\nsetup,Powder/Component 1/Density+Powder/Component "
                 "2/Density,(table),Powder/Component 1/Size classes\n\n"
                 "b,1 g/cm^3,3,\r\na,2 g/cm^3,4,\"1 mm: 50 %, 2 mm: 50 %\"\n"),
            (std::vector<std::string>{"Powder/Component 1/Density=2 g/cm^3",
                                      "Powder/Component 2/Density=2 g/cm^3",
                                      "Powder/Component 1/Size classes=1 mm: 50 %, 2 mm: 50 %"}));
  EXPECT_EQ(setup_names(folder_ / "case.prm"), (std::vector<std::string>{"b", "a"}));
}

TEST_F(SetupTable, LeaveTheEntryOfAnEmptyCell) {
  EXPECT_EQ(read("setup,Mode,Title\na,,x\n"), std::vector<std::string>{"Title=x"});
}

TEST_F(SetupTable, ThatAreUnknownAreRefusedWithTheNearest) {
  EXPECT_EQ(refusal("setup,Title\nE0250_CED1,x\nE0250_CED5,x\nE2500_CED5,x\nE3625_CED7,x\n",
                    "E0250_CED7"),
            "settings.csv: has no setup 'E0250_CED7' (it lists 4). Did you mean one of E0250_CED1, "
            "E0250_CED5, E2500_CED5?");
}

TEST_F(SetupTable, OfATableThatIsBrokenAreRefused) {
  EXPECT_EQ(refusal("setup,Titel\na,x\n"),
            "settings.csv:1: column 'Titel' is no entry of a case. Did you mean 'Title'?");
  EXPECT_EQ(refusal("setup,Title,\na,x,\n"),
            "settings.csv:1: has a column without a header. Remove it?");
  EXPECT_EQ(refusal("setup,Title\n# x\na,x,y\n"),
            "settings.csv:3: has 3 cells (the header has 2). Is a comma missing, or a "
            "cell with commas without quotes?");
  EXPECT_EQ(refusal("setup,Title\na,\"x\n"),
            "settings.csv:2: has a quote that is never closed. Add the other one?");
  EXPECT_EQ(refusal("setup,Title\na,x\na,y\n"),
            "settings.csv:3: setup a is listed twice (first on line 2). Rename one?");
  EXPECT_EQ(refusal("setup,Title\n,x\n"), "settings.csv:2: names no setup. Fill the first cell?");
  EXPECT_EQ(refusal("setup,Mode\na,soft\n").substr(0, 52),
            "settings.csv:2: Mode = soft: is none of the choices ");
  EXPECT_EQ(refusal("name,Mode\na,rigid\n"),
            "settings.csv:1: does not begin with the column 'setup'. Is this a table of setups?");
  EXPECT_EQ(refusal("setup,Mode\n"), "settings.csv: lists no setup. Is it the right file?");
  EXPECT_EQ(refusal(""), "settings.csv: lists no setup. Is it the right file?");
}

TEST_F(SetupTable, WithoutATableAreRefused) {
  try {
    setup_overrides(folder_ / "case.prm", "a");
    FAIL() << "accepted";
  } catch (dem::InvalidInput const& problem) {
    EXPECT_EQ(problem.what(), (folder_ / "settings.csv").string() +
                                  ": does not exist (named setups stand there, beside the case). "
                                  "Run the case without --setup?");
  }
}

} // namespace
} // namespace coupling
