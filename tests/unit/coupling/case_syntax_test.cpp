#include "coupling/case_file.hpp"

#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <string>

// Files that are no case: one message each, with file and line.
namespace coupling {
namespace {

std::string refusal(std::string const& text, std::string const& name = "case.prm") {
  try {
    parse_case(text, name);
    return "accepted";
  } catch (dem::InvalidInput const& problem) {
    return problem.what();
  }
}

std::string file_refusal(std::filesystem::path const& file) {
  try {
    read_case(file);
    return "accepted";
  } catch (dem::InvalidInput const& problem) {
    return problem.what();
  }
}

TEST(PrmFile, WithAnUnknownEntryIsRefusedAtItsLine) {
  EXPECT_EQ(refusal("# a case\nsubsection Tooling\n  set Bore diametr = 22.05 mm\nend\n"),
            "case.prm:3: Tooling/Bore diametr = 22.05 mm: is no entry of a case. Did you mean "
            "'Tooling/Bore diameter'?");
  EXPECT_EQ(refusal("subsection Tooling\n  set Bore diameter = 22.05 kg\nend\n"),
            "case.prm:2: Tooling/Bore diameter = 22.05 kg: has a unit that does not fit (a length "
            "is needed). Write it in m, "
            "mm, um?");
  EXPECT_EQ(refusal("\n\nsubsection Powder\n  set Total mass = 20 g\nend\n").substr(0, 40),
            "case.prm:4: Powder/Total mass = 20 g: fi");
}

TEST(PrmFile, WithAnUnknownSectionIsRefusedAtItsLine) {
  EXPECT_EQ(refusal("subsection Toolings\nend\n"),
            "case.prm:1: subsection Toolings: is no section of a case. Did you mean 'Tooling'?");
  EXPECT_EQ(refusal("subsection Powder\n  subsection Component 7\n"),
            "case.prm:2: subsection Powder/Component 7: is no section of a case. Did you mean "
            "'Powder/Component 1'?");
}

TEST(PrmFile, WithBrokenSectionsIsRefused) {
  EXPECT_EQ(refusal("subsection Powder\n  set Total mass = 5 g\n"),
            "case.prm:1: subsection Powder is never closed (its end is missing). Add 'end'?");
  EXPECT_EQ(refusal("set Mode = rigid\nend\n"),
            "case.prm:2: 'end': closes a subsection, but none is open. Remove it?");
  EXPECT_EQ(refusal("subsection Powder\nend Powder\n"),
            "case.prm:2: 'end Powder': has more than 'end' on its line. Put it on its own line?");
}

TEST(PrmFile, WithAnEntryTwiceIsRefused) {
  EXPECT_EQ(refusal("set Mode = rigid\nset Title = a\nset Mode = rigid\n"),
            "case.prm:3: Mode = rigid: is set twice (first on line 1). Remove one?");
}

TEST(PrmFile, WithALineThatIsNoneIsRefused) {
  EXPECT_EQ(refusal("Mode = rigid\n"),
            "case.prm:1: 'Mode = rigid': is no line of a .prm file (a line is: subsection NAME, "
            "set ENTRY = VALUE, end, or # a comment). Is a word missing?");
  EXPECT_EQ(
      refusal("set Mode rigid\n"),
      "case.prm:1: 'set Mode rigid': has no '=' (a line is: set ENTRY = VALUE). Add the value?");
}

TEST(PrmFile, ThatIncludesAnotherIsRefused) {
  EXPECT_EQ(refusal("include other.prm\n"),
            "case.prm:1: 'include other.prm': a case cannot include another file (it is kept as "
            "one file beside its results). Copy the "
            "lines here?");
}

TEST(PrmFile, ThatSaysNothingIsRefused) {
  std::string const nothing =
      "case.prm: sets no entry (a case sets at least its Title). Is this the right file?";
  EXPECT_EQ(refusal(""), nothing);
  EXPECT_EQ(refusal("\n \n# only words\n"), nothing);
  EXPECT_EQ(refusal("subsection Powder\nend\n"), nothing);
}

TEST(AnyFile, OfBytesThatAreNoTextIsRefused) {
  std::string const end = " that no text has (a case is UTF-8 text). Is this the right file?";
  EXPECT_EQ(refusal(std::string("set Mode = rigid\n\0\1\2", 20)),
            "case.prm:2: holds a byte 0x00" + end);
  EXPECT_EQ(refusal("set Title = \xff\n"), "case.prm:1: holds a byte 0xff" + end);
  EXPECT_EQ(refusal("set Title = \xc3\n"), "case.prm:1: holds a byte 0xc3" + end);
  EXPECT_EQ(refusal("\x89PNG\r\n\x1a\n"), "case.prm:1: holds a byte 0x89" + end);
  EXPECT_EQ(refusal(std::string((1u << 20) + 1, '\n')),
            "case.prm: has 1048577 bytes (a case has at most 1048576). Is this the right file?");
}

TEST(JsonFile, WithAnUnknownOrWrongEntryIsRefusedAtItsLine) {
  EXPECT_EQ(refusal("{\n  \"Tooling\": {\n    \"Bore diametr\": \"22 mm\"\n  }\n}", "case.json"),
            "case.json:3: Tooling/Bore diametr = 22 mm: is no entry of a case. Did you mean "
            "'Tooling/Bore diameter'?");
  EXPECT_EQ(
      refusal("{\"Powder\":\n{\"Total mass\":\n 9\n, \"Fill height\":\n\n 3e9\n}}", "case.json"),
      "case.json:4: Powder/Fill height = 3e9: is outside the allowed range (>= 1e-05 m, <= 2 m). "
      "Choose a value inside "
      "it?");
  EXPECT_EQ(refusal("{\"Powdr\": {}}", "case.json"),
            "case.json:1: section 'Powdr': is no section of a case. Did you mean 'Powder'?");
  EXPECT_EQ(refusal("{\"Mode\": \"rigid\",\n\"Mode\": \"rigid\"}", "case.json"),
            "case.json:2: Mode = rigid: is set twice (first on line 1). Remove one?");
  EXPECT_EQ(refusal("{\"Mode\": null}", "case.json").substr(0, 48),
            "case.json:1: Mode = null: is none of the choices");
  EXPECT_EQ(refusal("{\"Mode\": [\"rigid\"]}", "case.json"),
            "case.json:1: 'Mode' is a list (entries are texts, such as \"0.5 mm: 35 %, 1 mm: 65 "
            "%\"). Write it as one text?");
}

TEST(JsonFile, ThatIsNoObjectIsRefused) {
  EXPECT_EQ(refusal("{\"Mode\": \"rigid\",\n}", "case.json"),
            "case.json:2: is no JSON at '}'. Is a comma, quote or bracket missing or left over?");
  EXPECT_EQ(refusal("", "case.json"),
            "case.json:1: is no JSON at ''. Is a comma, quote or bracket missing or left over?");
  EXPECT_EQ(refusal("3", "case.json"), "case.json: holds no JSON object (a case is one object of "
                                       "sections). Is this the right file?");
  EXPECT_EQ(refusal("{}", "case.json"),
            "case.json: sets no entry (a case sets at least its Title). Is this the right file?");
  EXPECT_EQ(refusal("{\"Title\": \"a\\nb\"}", "case.json"),
            "case.json:1: Title = a b: holds '#', a tab, a line end, or a backslash at its end (a "
            ".prm file could not hold "
            "it). Leave it out?");
}

TEST(CaseFile, ThatIsMissingOrAFolderIsRefused) {
  support::ScratchFolder const folder;
  std::string const path = folder.path().string();
  EXPECT_EQ(file_refusal(folder / "no.prm"),
            path + "/no.prm: does not exist (no such case file). Is it misspelt?");
  EXPECT_EQ(file_refusal(folder.path()),
            path + ": is a folder (a case is a .prm or .json file). Did you mean " + path +
                "/case.prm?");
  support::put_bytes(folder / "empty.prm", "");
  EXPECT_EQ(
      file_refusal(folder / "empty.prm"),
      path + "/empty.prm: sets no entry (a case sets at least its Title). Is this the right file?");
}

TEST(CaseFile, KeepsItsPlaceWhenItsFilesAreRelative) {
  support::ScratchFolder const folder;
  support::put_bytes(folder / "grains.csv", "x");
  support::put_bytes(
      folder / "case.prm",
      "subsection Powder\nset Fill method = file\nset Fill file = grains.csv\nend\n");
  EXPECT_EQ(read_case(folder / "case.prm").powder.fill_file, folder / "grains.csv");
}

} // namespace
} // namespace coupling
