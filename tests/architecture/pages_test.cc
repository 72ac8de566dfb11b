#include "tests/architecture/pages.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/source_tree.h"
#include "tests/support/test_folder.h"

namespace vehicle::test {
namespace {

namespace fs = std::filesystem;

std::string lines(const Violations& violations) {
  std::string text;
  for (const std::string& line : violations) text += line + '\n';
  return text;
}

/// Made-up pages beside one room.
class Pages {
 public:
  Pages() {
    put("libvehicle/CMakeLists.txt", "vehicle_room(xml)\n");
    put("libvehicle/xml/CMakeLists.txt", "vehicle_files(HEADERS reader.h)\n");
    put("libvehicle/xml/reader.h", "");
    put("CHANGELOG.md", "# Changes\n");
  }
  void put(const std::string& path, const std::string& text) const { folder_.file(path, text); }
  const fs::path& root() const { return folder_.root(); }

 private:
  TestFolder folder_;
};

// ---- this tree

TEST(Pages, EveryLinkLeadsSomewhere) { EXPECT_EQ(lines(deadLinks(sourcePath())), ""); }

TEST(Pages, EveryPathThatIsNamedExists) { EXPECT_EQ(lines(pathsToNothing(sourcePath())), ""); }

TEST(Pages, EveryPageIsReachedFromTheReadme) { EXPECT_EQ(lines(lonelyPages(sourcePath())), ""); }

// ---- the checker itself, on pages that are wrong

TEST(PagesChecker, FollowsLinksToFilesAndHeadings) {
  const Pages pages;
  pages.put("docs/a.md", "# One & two\n```\n# no heading\n```\n[up](../README.md) [self](#one--two)\n");
  pages.put("README.md",
            "[a](docs/a.md) [b](docs/b.md)\n"
            "[c](docs/a.md#one--two) [d](docs/a.md#no-heading)\n"
            "[site](https://example.org/x.md) `[e](docs/e.md)`\n"
            "```\n[f](docs/f.md)\n```\n"
            "[`g`](docs/g.md) [out](../x.md)\n");
  EXPECT_EQ(lines(deadLinks(pages.root())),
            "README.md:1: the link leads to docs/b.md, which does not exist\n"
            "README.md:2: the link leads to #no-heading, and docs/a.md has no such heading\n"
            "README.md:7: the link leads to docs/g.md, which does not exist\n"
            "README.md:7: the link leads to ../x.md, which does not exist\n");
}

TEST(PagesChecker, NamesPathsThatDoNotExist) {
  const Pages pages;
  pages.put("README.md",
            "    vehicle check models/coach.xml docs/a.md, docs/*.md\n"
            "`xml/reader.h`, `xml/writer.h`, xml/or, `tests/...`, libvehicle/<room>\n");
  pages.put("docs/a.md", "see tools/run.sh.\n");
  pages.put("libvehicle/xml/reader.h", "// docs/a.md (2.1)\n// docs/theory/b.md (3)\n");
  EXPECT_EQ(lines(pathsToNothing(pages.root())),
            "README.md:1: names models/coach.xml, which does not exist\n"
            "README.md:2: names libvehicle/xml/writer.h, which does not exist\n"
            "docs/a.md:1: names tools/run.sh, which does not exist\n"
            "libvehicle/xml/reader.h:2: names docs/theory/b.md, which does not exist\n");
}

TEST(PagesChecker, NamesPagesThatNothingLeadsTo) {
  const Pages pages;
  pages.put("README.md", "[a](docs/a.md)\n");
  pages.put("docs/a.md", "[b](how-to/b.md)\n");
  pages.put("docs/how-to/b.md", "[a](../a.md)\n");
  pages.put("docs/how-to/c.md", "[a](../a.md)\n");
  EXPECT_EQ(lines(lonelyPages(pages.root())), "docs/how-to/c.md:1: no link leads here from README.md\n");
}

}  // namespace
}  // namespace vehicle::test
