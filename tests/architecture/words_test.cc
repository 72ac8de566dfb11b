#include "tests/architecture/words.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/source_tree.h"
#include "tests/support/test_folder.h"

namespace vehicle::test {
namespace {

TEST(PrivateWords, AreFoundWithFileAndLineAndTheTermOfTheField) {
  const TestFolder folder;
  folder.file("libvehicle/a.h", std::string("// a smooth line\nstruct Mis") + "fit {};\n");
  folder.file("docs/a.md", std::string("compare them by tur") + "ns\n");
  const Violations found = privateWords(folder.root());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], std::string("docs/a.md:1: \"by tur") + "ns\"; say alternately");
  EXPECT_EQ(found[1], std::string("libvehicle/a.h:2: \"Mis") + "fit\"; say unsupported, reason");
}

TEST(PrivateWords, StandNowhereInTheProject) {
  const Violations found = privateWords(sourcePath());
  for (const std::string& each : found) ADD_FAILURE() << each;
}

}  // namespace
}  // namespace vehicle::test
