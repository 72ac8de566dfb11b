#include "tests/architecture/layering.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/source_tree.h"
#include "tests/support/test_folder.h"

namespace vehicle::test {
namespace {

namespace fs = std::filesystem;

/// A made-up tree that is gone with the test.
class Tree {
 public:
  Tree() {
    put("libvehicle/CMakeLists.txt",
        "include(room.cmake)\n"
        "vehicle_room(units)  # vehicle_room(ghost)\n"
        "vehicle_room(xml     USES units      PRIVATE tinyxml2::tinyxml2 fmt::fmt)\n"
        "vehicle_room(system  USES units\n"
        "                     PUBLIC Eigen3::Eigen)\n"
        "vehicle_room(mbs     USES system     PRIVATE vehicle_simbody)\n"
        "vehicle_room(run     USES mbs system)\n");
    room("units", "quantity.h", "");
    room("xml", "reader.h", "#include <string>\n");
    room("system", "system.h", "#include <Eigen/Core>\n");
    room("mbs", "form.h", "");
    room("run", "run.h", "#include \"libvehicle/system/system.h\"\n");
  }
  const fs::path& root() const { return folder_.root(); }
  void put(const std::string& path, const std::string& text) const { folder_.file(path, text); }
  void room(const std::string& name, const std::string& header, const std::string& text) const {
    put("libvehicle/" + name + "/CMakeLists.txt", "vehicle_files(HEADERS " + header + "\n  SOURCES a.cc)\n");
    put("libvehicle/" + name + "/" + header, text);
    put("libvehicle/" + name + "/a.cc", "");
  }

 private:
  TestFolder folder_;
};

Violations sorted(Violations violations) {
  std::sort(violations.begin(), violations.end());
  return violations;
}

std::string lines(const Violations& violations) {
  std::string text;
  for (const std::string& line : violations) text += line + '\n';
  return text;
}

// ---- this tree

TEST(Architecture, EveryArrowPointsDown) {
  EXPECT_EQ(lines(House(sourcePath()).wrongArrows()), "");
  EXPECT_GE(House(sourcePath()).rooms().size(), 16u);
}

TEST(Architecture, EveryIncludeFollowsADeclaredArrow) { EXPECT_EQ(lines(wrongIncludes(sourcePath())), ""); }

TEST(Architecture, EveryFileIsListedInItsRoom) { EXPECT_EQ(lines(wrongFiles(sourcePath())), ""); }

TEST(Architecture, NoFileIsLongerThanFourHundredLines) { EXPECT_EQ(lines(longFiles(sourcePath())), ""); }

TEST(Architecture, TheTopFolderHoldsNothingElse) { EXPECT_EQ(lines(strayEntries(sourcePath())), ""); }

// ---- the checker itself, on trees that are wrong

TEST(ArchitectureChecker, FindsNothingInATidyTree) {
  const Tree tree;
  EXPECT_EQ(lines(House(tree.root()).wrongArrows()), "");
  EXPECT_EQ(lines(wrongIncludes(tree.root())), "");
  EXPECT_EQ(lines(wrongFiles(tree.root())), "");
  EXPECT_EQ(lines(longFiles(tree.root())), "");
  EXPECT_EQ(lines(strayEntries(tree.root())), "");
}

TEST(ArchitectureChecker, NamesUpwardAndUndeclaredIncludes) {
  const Tree tree;
  tree.put("libvehicle/units/a.cc", "// up\n#include \"libvehicle/xml/reader.h\"\n");
  tree.put("libvehicle/run/a.cc", "#include \"libvehicle/mbs/form.h\"\n  #  include \"libvehicle/units/quantity.h\"\n");
  tree.put("libvehicle/xml/a.cc",
           "#include \"reader.h\"\n#include \"apps/cli/main.h\"\n#include \"libvehicle/x/y.h\"\n");
  EXPECT_EQ(lines(wrongIncludes(tree.root())),
            "libvehicle/run/a.cc:2: room run does not use room units (\"libvehicle/units/quantity.h\")\n"
            "libvehicle/units/a.cc:2: room units does not use room xml (\"libvehicle/xml/reader.h\")\n"
            "libvehicle/xml/a.cc:1: \"reader.h\" is no path from the top folder\n"
            "libvehicle/xml/a.cc:2: \"apps/cli/main.h\" is in no room\n"
            "libvehicle/xml/a.cc:3: \"libvehicle/x/y.h\" is in no room\n");
}

TEST(ArchitectureChecker, NamesLibrariesOutsideTheirRooms) {
  const Tree tree;
  tree.put("libvehicle/units/a.cc", "#include <fmt/format.h>\n#include <cmath>\n#include <sys/stat.h>\n");
  tree.put("libvehicle/xml/a.cc", "#include <tinyxml2.h>\n#include <Eigen/Core>\n#include <CLI/CLI.hpp>\n");
  tree.put("libvehicle/run/a.cc", "#include <Eigen/Dense>\n#include <Simbody.h>\n#include <gsl/gsl_math.h>\n");
  tree.put("libvehicle/mbs/a.cc", "#include <Simbody.h>\n#include <experimental/simd>\n");
  tree.put("apps/cli/main.cc", "#include <CLI/CLI.hpp>\n#include \"libvehicle/units/quantity.h\"\n");
  EXPECT_EQ(lines(wrongIncludes(tree.root())),
            "libvehicle/mbs/a.cc:1: <Simbody.h> belongs in libvehicle/mbs/simbody_model.cc alone\n"
            "libvehicle/mbs/a.cc:2: <experimental/simd> belongs in libvehicle/ensemble/kernel.inc alone\n"
            "libvehicle/run/a.cc:2: room run does not declare vehicle_simbody (<Simbody.h>)\n"
            "libvehicle/run/a.cc:3: <gsl/gsl_math.h> is unknown; name its library in tests/architecture/layering.cc\n"
            "libvehicle/units/a.cc:1: room units does not declare fmt::fmt (<fmt/format.h>)\n"
            "libvehicle/xml/a.cc:2: room xml does not declare Eigen3::Eigen (<Eigen/Core>)\n"
            "libvehicle/xml/a.cc:3: <CLI/CLI.hpp> belongs in apps/ alone\n");
}

TEST(ArchitectureChecker, NamesAPrivateLibraryInAPublicHeader) {
  const Tree tree;
  tree.put("libvehicle/xml/reader.h", "#pragma once\n#include <tinyxml2.h>\n");
  EXPECT_EQ(lines(wrongIncludes(tree.root())),
            "libvehicle/xml/reader.h:2: <tinyxml2.h> is private to room xml and stands in a public header\n");
}

TEST(ArchitectureChecker, NamesArrowsThatPointUpOrNowhere) {
  const Tree tree;
  tree.put("libvehicle/CMakeLists.txt",
           "vehicle_room(units USES system)\nvehicle_room(system USES units\n  attic)\nvehicle_room(mbs USES mbs)\n");
  EXPECT_EQ(lines(sorted(House(tree.root()).wrongArrows())),
            "libvehicle/CMakeLists.txt:1: room units uses system, which does not stand below it\n"
            "libvehicle/CMakeLists.txt:2: room system uses attic, which is no room\n"
            "libvehicle/CMakeLists.txt:4: room mbs uses mbs, which does not stand below it\n");
}

TEST(ArchitectureChecker, NamesFilesThatNobodyBuilds) {
  const Tree tree;
  tree.put("libvehicle/util/a.cc", "");
  tree.put("libvehicle/mbs/forgotten.cc", "");
  tree.put("libvehicle/run/later/a.cc", "");  // the listed a.cc is another one
  fs::remove(tree.root() / "libvehicle/xml/a.cc");
  EXPECT_EQ(lines(sorted(wrongFiles(tree.root()))),
            "libvehicle/mbs/forgotten.cc:1: libvehicle/mbs/CMakeLists.txt does not list this file\n"
            "libvehicle/run/later/a.cc:1: libvehicle/run/CMakeLists.txt does not list this file\n"
            "libvehicle/util:1: no vehicle_room() declares this folder\n"
            "libvehicle/xml/CMakeLists.txt:1: lists a.cc, which does not exist\n");
}

TEST(ArchitectureChecker, NamesLongFilesAndStrayEntries) {
  const Tree tree;
  std::string text;
  for (int i = 0; i < 400; ++i) text += "//\n";
  tree.put("apps/cli/long_enough.cc", text);
  tree.put("apps/cli/too_long.cc", text + "//\n");
  EXPECT_EQ(lines(longFiles(tree.root())),
            "apps/cli/too_long.cc:401: the file has 401 lines, at most 400; split it by ideas\n");
  tree.put(".gitignore", "/build/\n*.log\n");
  tree.put("build/x", "");
  tree.put("a.log", "");
  tree.put("src/x.cc", "");
  EXPECT_EQ(lines(strayEntries(tree.root())), "src:1: has no place in the top folder\n");
}

TEST(ArchitectureChecker, ATreeWithoutRoomsIsAnErrorNotAPass) {
  const Tree tree;
  tree.put("libvehicle/CMakeLists.txt", "# no rooms\n");
  EXPECT_THROW(House(tree.root()), std::runtime_error);
}

}  // namespace
}  // namespace vehicle::test
