#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "libvehicle/xml/named_file.h"
#include "libvehicle/xml/reader.h"
#include "tests/xml/files.h"

namespace vehicle {
namespace {

struct Bytes {
  std::string text;
  const char* says;
};

TEST(FileGuard, WhatIsNoRightXmlIsToldAtItsLine) {
  const std::vector<Bytes> cases = {
      {std::string("", 0),
       R"(a.xml: error: the file holds no element; write e.g. <vehicle name="coach" format="1"> ... </vehicle>
)"},
      {std::string("  \n\n", 4),
       R"(a.xml: error: the file holds no element; write e.g. <vehicle name="coach" format="1"> ... </vehicle>
)"},
      {std::string("<!-- nothing -->", 16),
       R"(a.xml: error: the file holds no element; write e.g. <vehicle name="coach" format="1"> ... </vehicle>
)"},
      {std::string("just words", 10),
       R"(a.xml:1: error: the text "just words" stands outside the root element; remove it
)"},
      {std::string("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<vehicle/>", 54),
       R"(a.xml:1: error: encoding="ISO-8859-1"; files are UTF-8; save the file as UTF-8 and write encoding="UTF-8"
)"},
      {std::string("<vehicle name=\"K\366rper\"/>", 24),
       R"(a.xml:1: error: byte 0xF6 is no UTF-8; save the file as UTF-8
)"},
      {std::string("\377\376<\000v\000", 6),
       R"(a.xml:1: error: byte 0xFF is no UTF-8; save the file as UTF-8
)"},
      {std::string("<vehicle>\n\000</vehicle>", 21),
       R"(a.xml:2: error: the control character 0x00 is no text; remove it
)"},
      {std::string("<vehicle>\n\n\033[31m</vehicle>", 26),
       R"(a.xml:3: error: the control character 0x1B is no text; remove it
)"},
      {std::string("<vehicle>\357\277\277</vehicle>", 22),
       R"(a.xml:1: error: the code points U+FFFE and U+FFFF are no characters; remove them
)"},
      {std::string("<!DOCTYPE vehicle [<!ENTITY a \"b\">]>\n<vehicle/>", 47),
       R"(a.xml:1: error: document types and entity declarations ("<!") are not allowed; remove it; the program knows its files without
)"},
      {std::string("<vehicle name=\"&lol;\">\n &lol; &#0; &#xD800; &amp; &#65; &\n</vehicle>", 68),
       R"(a.xml:1: error: the entity "&lol;" is not allowed; write what it stands for
a.xml:2: error: the entity "&lol;" is not allowed; write what it stands for
a.xml:2: error: the entity "&#0;" is not allowed; write what it stands for
a.xml:2: error: the entity "&#xD800;" is not allowed; write what it stands for
a.xml:2: error: "&" stands alone; write "&amp;"
)"},
      {std::string("<?xml version=\"1.0\"?>\n<?xml-stylesheet href=\"a.css\"?>\n<vehicle/>", 64),
       R"(a.xml:2: error: processing instructions ("<?") are not allowed here; only <?xml version="1.0" encoding="UTF-8"?> may stand, at the very beginning, and <?xml-model ...?> outside the root element
)"},
      {std::string("<?php echo ?", 12),
       R"(a.xml:1: error: processing instructions ("<?") are not allowed here; only <?xml version="1.0" encoding="UTF-8"?> may stand, at the very beginning, and <?xml-model ...?> outside the root element
a.xml:1: error: "<?" is not closed; close it with "?>"
)"},
      {std::string("<vehicle>\n<!-- open ->\n</vehicle>", 33),
       R"(a.xml:2: error: "<!--" is not closed; close it with "-->"
)"},
      {std::string("<vehicle><!-- a -- b --></vehicle>", 34),
       R"(a.xml:1: error: "--" stands inside a comment; XML ends comments there; write "-"
)"},
      {std::string("<vehicle><title><![CDATA[ x </title></vehicle>", 46),
       R"(a.xml:1: error: "<![CDATA[" is not closed; close it with "]]>"
)"},
      {std::string("<vehicle>\n<body>\n</vehicle>", 27),
       R"(a.xml:3: error: </vehicle> stands where <body> of line 2 is still open; close that with </body>, or with "/>" in its own tag
)"},
      {std::string("<vehicle>\n<body>\n", 17),
       R"(a.xml:2: error: <body> is not closed before the end of the file; close it with </body>
)"},
      {std::string("</vehicle>", 10),
       R"(a.xml:1: error: </vehicle> closes nothing; remove it, or open the element before
)"},
      {std::string("<vehicle><title>a ]]> b</title></vehicle>", 41),
       R"(a.xml:1: error: "]]>" stands in a text; write "]]&gt;"
)"},
      {std::string("<vehicle/>\n<![CDATA[x]]>", 24),
       R"(a.xml:2: error: "<![CDATA[" stands outside the root element; remove it
)"},
      {std::string("<vehicle></vehicle></vehicle>", 29),
       R"(a.xml:1: error: </vehicle> closes nothing; remove it, or open the element before
)"},
      {std::string("<vehicle></vehicle >\n</ vehicle>", 32),
       R"(a.xml:2: error: "</ v" is no closing tag; closing tags are of the form </body>
)"},
      {std::string("<vehicle\n  name=coach>", 22),
       R"(a.xml:2: error: <vehicle>: "name=coach" is no attribute; attributes are of the form name="value"
)"},
      {std::string("<vehicle name>", 14),
       R"(a.xml:1: error: <vehicle>: "name" is no attribute; attributes are of the form name="value"
)"},
      {std::string("<vehicle name=\"v\"format=\"1\"/>", 29),
       R"(a.xml:1: error: <vehicle>: no space stands before "format"; put one there
)"},
      {std::string("<vehicle name=\"v\" name=\"w\"/>", 28),
       R"(a.xml:1: error: <vehicle>: attribute "name" stands twice; remove one of them
)"},
      {std::string("<vehicle name=\"v\n  <body/>", 26),
       R"(a.xml:1: error: <vehicle>: the value of "name" is not closed; close it with a quotation mark; "<" inside a value is written "&lt;"
)"},
      {std::string("<vehicle name=\"v", 16),
       R"(a.xml:1: error: <vehicle>: the value of "name" is not closed; close it with a quotation mark; "<" inside a value is written "&lt;"
)"},
      {std::string("<vehicle name=\"v\" <body/>", 25),
       R"(a.xml:1: error: the tag of <vehicle> is not closed; close it with ">" or "/>"
)"},
      {std::string("<vehicle> 1 < 2 </vehicle>", 26),
       R"(a.xml:1: error: "<" begins no tag; write "&lt;" for the character itself
)"},
      {std::string("<vehicle name=\"v\"", 17),
       R"(a.xml:1: error: the tag of <vehicle> is not closed; close it with ">" or "/>"
)"},
      {std::string("<vehicle \"v\">", 13),
       R"(a.xml:1: error: <vehicle>: ""v"" is no attribute; attributes are of the form name="value"
)"},
      {std::string("<vehicle name=\"v\" format=\"1\"/><vehicle/>", 40),
       R"(a.xml:1: error: a second root element <vehicle> stands in the file; one file holds one
)"},
      {std::string("<vehicle name=\"v\" format=\"1\"/>\nrest", 35),
       R"(a.xml:2: error: the text "rest" stands outside the root element; remove it
)"},
      {std::string("<vehicel/>", 10),
       R"(a.xml:1: error: the root element <vehicel> is unknown; did you mean <vehicle>?
)"},
      {std::string("<report/>", 9),
       R"(a.xml:1: error: the root element <report> is unknown; a file holds one of <vehicle>, <train>, <scenario>, <suite>, <study>
)"},
  };
  for (const Bytes& each : cases) {
    const auto outcome = readVehicleText(each.text, "a.xml");
    EXPECT_EQ(outcome.problems.text(), each.says);
    EXPECT_FALSE(outcome.value.has_value()) << each.text;
  }
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST(FileGuard, FilesOfMoreThanAMegabyteAreRefused) {
  EXPECT_EQ(readVehicleText(std::string((1 << 20) + 1, ' '), "a.xml").problems.text(),
            "a.xml: error: the file is larger than 1024 KiB; no vehicle, scenario or suite needs as much: is it the "
            "right file?\n");
  EXPECT_EQ(
      readVehicleText(std::string(1 << 20, ' '), "a.xml").problems.text(),
      "a.xml: error: the file holds no element; write e.g. <vehicle name=\"coach\" format=\"1\"> ... </vehicle>\n");
}

TEST(FileGuard, DeepNestingIsRefusedBeforeItCanFillTheStack) {
  EXPECT_EQ(readVehicleText(repeated("<a>", 300000), "a.xml").problems.text(),
            "a.xml:1: error: elements stand more than 32 deep in each other; close some of them before\n");
}

TEST(FileGuard, AMegabyteOfAttributesIsRefusedAtOnce) {
  std::string text = "<vehicle";
  for (int i = 0; i < 90000; ++i) text += " a" + std::to_string(i) + "=\"\"";
  EXPECT_EQ(readVehicleText(text + "/>", "a.xml").problems.text(),
            "a.xml:1: error: <vehicle> has more than 64 attributes; remove some\n");
}

TEST(FileGuard, LongValuesAreCutInMessages) {
  EXPECT_EQ(readVehicleText("<" + std::string(100000, 'a') + "/>", "a.xml").problems.text(),
            "a.xml:1: error: the root element <" + std::string(60, 'a') +
                "...> is unknown; a file holds one of <vehicle>, <train>, <scenario>, <suite>, <study>\n");
}

// One line per problem would be as useless as none where a wrong file gives thousands.
TEST(FileGuard, ThousandsOfProblemsAreCutAtTwoHundred) {
  const std::string last = "there are more than 200 problems; correct these first; the others are printed then\n";
  const std::string open = "<vehicle name=\"v\" format=\"1\">\n";
  for (const std::string& each : {std::string("<x/>\n"), std::string("&\n"), std::string("<wheelset name=\"w\"/>\n")}) {
    const ProblemList problems = readVehicleText(open + repeated(each, 20000) + "</vehicle>", "a.xml").problems;
    EXPECT_EQ(problems.size(), 201u) << each;
    EXPECT_EQ(problems[200].message + "; " + problems[200].remedy + "\n", last);
  }
}

TEST(FileGuard, CommentsReferencesAndTheDeclarationAreFree) {
  test::Lines lines = test::kVehicleLines;
  lines[0] = "\xEF\xBB\xBF<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!-- a <comment> & more - -->\n" + lines[0];
  lines[1] =
      "<title>A &amp; B &lt;&gt; &#215; &#xD7; \xC3\x97 <![CDATA[<raw> & co]]>\n   wrapped</title><!---->\n" + lines[1];
  const auto outcome = readVehicleText(test::textOf(lines), "a.xml");
  EXPECT_EQ(outcome.problems.text(), "");
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(outcome.value->title, "A & B <> \xC3\x97 \xC3\x97 \xC3\x97 <raw> & co wrapped");
}

TEST(Files, WhatCannotBeReadIsToldWithTheReason) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "vehicle_unreadable";
  std::filesystem::create_directories(folder);
  const std::string name = folder.string();
  EXPECT_EQ(readVehicle(name + "/none.xml").problems.text(),
            name + "/none.xml: error: cannot be read: No such file or directory; check the name of the file\n");
  EXPECT_EQ(readVehicle(name).problems.text(), name + ": error: is a folder; name a file in it\n");
  EXPECT_EQ(readVehicle("/dev/zero").problems.text(),
            "/dev/zero: error: is no regular file; copy what it gives into a file\n");
  // A regular file whose first byte nobody may read, not even root: no page is mapped at address 0.
  EXPECT_EQ(readVehicle("/proc/self/mem").problems.text(),
            "/proc/self/mem: error: cannot be read: Input/output error; check its permissions\n");
  EXPECT_EQ(kindOf(name + "/none.xml").problems.size(), 1u);
}

TEST(Files, TheRootElementTellsTheKind) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "vehicle_kinds";
  std::filesystem::create_directories(folder);
  const auto put = [&folder](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  };
  const std::string vehicle = put("v.xml", test::textOf(test::kVehicleLines));
  const std::string scenario = put("s.xml", test::textOf(test::kScenarioLines));
  const std::string suite = put("u.xml", test::textOf(test::kSuiteLines));
  EXPECT_EQ(kindOf(vehicle).value, FileKind::kVehicle);
  EXPECT_EQ(kindOf(scenario).value, FileKind::kScenario);
  EXPECT_EQ(kindOf(suite).value, FileKind::kSuite);
  EXPECT_TRUE(readVehicle(vehicle).ok() && readScenario(scenario).ok() && readSuite(suite).ok());
  EXPECT_EQ(readVehicle(scenario).problems.text(),
            scenario + ":1: error: the file holds a <scenario>; a <vehicle> is expected here\n");
}

TEST(Files, NamesCountFromTheFolderOfTheNamingFile) {
  EXPECT_EQ(resolvePath("models/suites/a.xml", "../vehicles/b.xml"), "models/vehicles/b.xml");
  EXPECT_EQ(resolvePath("a.xml", "b.xml"), "b.xml");
  EXPECT_EQ(resolvePath("models/a.xml", "/tmp/b.xml"), "/tmp/b.xml");
}

}  // namespace
}  // namespace vehicle
