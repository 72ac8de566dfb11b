// vehicle check - : a file of any kind from standard input, its files named from the current folder.
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "tests/cli/studies.h"

namespace vehicle::test {
namespace {

/// `vehicle check WORDS` in a folder, with the text as its standard input.
ProgramRun checked(const TestFolder& folder, const std::string& text, const std::string& words = "-") {
  folder.file("given", text);
  const std::string line =
      "cd '" + folder.root().string() + "' && '" + programPath() + "' check " + words + " <given >out 2>err";
  const int state = std::system(line.c_str());
  return {WEXITSTATUS(state), textOf(folder.path("out")), textOf(folder.path("err"))};
}

TEST(StandardInput, IsCheckedAsAFileOfAnyKind) {
  const TestFolder folder;
  static_cast<void>(smallStudyIn(folder));
  const std::string files = R"(<vehicle file="v.xml"/> <scenario file="s.xml"/>)";
  for (const std::string& text :
       {smallVehicle(), textOf(folder.path("s.xml")), smallStudy(),
        "<suite name=\"all\" format=\"1\">" + files + R"(<form name="matrix"/> <form name="mbs"/></suite>)",
        std::string(R"(<train name="pair" format="1"><vehicle file="v.xml" count="2" spacing="12 m"/></train>)")}) {
    const ProgramRun run = checked(folder, text);
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    EXPECT_EQ(run.out, "<stdin>: ok\n") << text;
  }
}

TEST(StandardInput, HasProblemsAtItsLinesAndFilesThatAreNotThere) {
  const TestFolder folder;
  const ProgramRun wrong = checked(folder, with(smallVehicle(), "10 t", "10 m"));
  EXPECT_EQ(wrong.status, 1);
  EXPECT_TRUE(wrong.out.starts_with("<stdin>:3: error: <vehicle><body>: mass=\"10 m\"")) << wrong.out;
  const ProgramRun none = checked(folder, smallStudy());
  EXPECT_EQ(none.status, 1);
  EXPECT_TRUE(has(none.out, "<stdin>:2: error: ") && has(none.out, "file=\"v.xml\"")) << none.out;
  EXPECT_EQ(checked(folder, "").status, 1);
  EXPECT_EQ(checked(folder, std::string(2 << 20, ' ')).status, 1);
}

TEST(StandardInput, IsCheckedTogetherWithTheFilesBesideIt) {
  const TestFolder folder;
  static_cast<void>(smallStudyIn(folder));
  const std::string scenario = with(textOf(folder.path("s.xml")), "</scenario>",
                                    R"(<initial_state><body name="carboody" z="1 mm"/></initial_state></scenario>)");
  EXPECT_EQ(checked(folder, scenario).status, 0);
  const ProgramRun run = checked(folder, scenario, "v.xml -");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(run.out.starts_with("v.xml: ok\n<stdin>:")) << run.out;
  const ProgramRun twice = checked(folder, scenario, "- -");
  EXPECT_EQ(twice.status, 2);
  EXPECT_EQ(twice.err,
            "vehicle: check: \"-\" is given twice, and standard input can be read once; give it once\n");
}

}  // namespace
}  // namespace vehicle::test
