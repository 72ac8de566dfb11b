#include <filesystem>
#include <functional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/project/check_file.h"
#include "libvehicle/xml/schema.h"
#include "tests/support/test_folder.h"

// Every attribute and element of a file spoilt in turn, in every way: one mistake is one line, with the file and the line
// of the mistake, and nothing is quoted that the file does not say.
namespace vehicle::test {
namespace {

using Lines = std::vector<std::string>;

// One line an element, so that the line names it.
const Lines kWagon = {
    R"(<vehicle name="wagon" format="1">)",
    R"(<title>Four-axle wagon</title>)",
    R"(<element name="primary" stiffness_z="3040 kN/m" damping_z="30 kN*s/m" stiffness_y="1 MN/m"/>)",
    R"(<element name="secondary" stiffness_z="2660 kN/m" damping_z="100 kN*s/m"/>)",
    R"(<element name="damper" damping_z="20 kN*s/m"/>)",
    R"(<body name="carbody" mass="57 t" pitch_inertia="700 t*m^2" motion="z pitch" z="2 m" roll_inertia="50 t*m^2"/>)",
    R"(<group name="front" x="5 m">)",
    R"(<body name="bogie_a" mass="9 t" pitch_inertia="9 t*m^2" motion="z pitch" z="1 m"/>)",
    R"(<wheelset name="axle_1" x="1.5 m" mass="1.5 t" hertz_constant="90 GN/m^1.5" contact_damping="9 kN*s/m"/>)",
    R"(<wheelset name="axle_2" x="-1.5 m"/>)",
    R"(<suspension name="s_front" element="secondary" upper="carbody" lower="bogie_a" z_upper="1.1 m" z_lower="1 m"/>)",
    R"(<suspension name="d_front" element="damper" upper="carbody" lower="bogie_a" x="0.3 m" z="1 m"/>)",
    R"(<suspension name="p1" element="primary" upper="bogie_a" lower="axle_1" x="1.5 m" z="0.5 m" y="1 m" sides="2"/>)",
    R"(<suspension name="p2" element="primary" upper="bogie_a" lower="axle_2" x="-1.5 m" z="0.5 m" y="1 m" sides="2"/>)",
    R"(</group>)",
    R"(<group name="rear" x="-5 m">)",
    R"(<body name="bogie_b" mass="9 t" pitch_inertia="9 t*m^2" motion="z pitch" z="1 m"/>)",
    R"(<wheelset name="axle_3" x="1.5 m"/>)",
    R"(<wheelset name="axle_4" x="-1.5 m" mass="1.5 t" contact_stiffness="2 GN/m"/>)",
    R"(<suspension name="s_rear" element="secondary" upper="carbody" lower="bogie_b" z="1 m"/>)",
    R"(<suspension name="p3" element="primary" upper="bogie_b" lower="axle_3" x="1.5 m" z="0.5 m"/>)",
    R"(<suspension name="p4" element="primary" upper="bogie_b" lower="axle_4" x="-1.5 m" z="0.5 m"/>)",
    R"(</group>)",
    R"(<point name="floor" body="carbody" x="2 m"/>)",
    R"(</vehicle>)"};

const Lines kTrack = {
    R"(<scenario name="track" format="1" gravity="9.81 m/s^2">)",
    R"(<run speed="20 m/s" duration="10 s" output_step="5 ms"/>)",
    R"(<track history="onset" fade_in="50 m">)",
    R"(<harmonic name="wave" wavelength="25 m" order="3" amplitude="5 mm" phase="1 rad" rail="left"/>)",
    R"(<dip name="hole" shape="half_sine" depth="8 mm" length="2 m" start="20 m" rail="right"/>)",
    R"(<bump name="joint" shape="half_sine" height="8 mm" length="2 m" start="30 m"/>)",
    R"(<ramp name="rise" rise="10 mm" length="5 m" start="60 m"/>)",
    R"(</track>)",
    R"(<initial_state from="on_rail">)",
    R"(<body name="carbody" z="1 mm" pitch="1 mrad" z_rate="1 mm/s" pitch_rate="1 mrad/s"/>)",
    R"(</initial_state>)",
    R"(</scenario>)"};

const Lines kRig = {R"(<scenario name="rig" format="1">)",
                    R"(<run duration="10 s" output_step="5 ms"/>)",
                    R"(<rig>)",
                    R"(<input wheelset="axle_1">)",
                    R"(<sine name="slow" amplitude="6 mm" angular_frequency="5 rad/s" phase="0.3 rad"/>)",
                    R"(<sine name="fast" amplitude="1 mm" frequency="3 Hz"/>)",
                    R"(</input>)",
                    R"(</rig>)",
                    R"(</scenario>)"};

const Lines kTrain = {R"(<train name="train" format="1">)",
                      R"(<vehicle file="wagon.xml" name="wagon" count="3" spacing="20 m" end_x="9 m"/>)",
                      R"(<coupling stiffness_z="50 kN/m" damping_z="20 kN*s/m" end_x="9 m" z="1 m"/>)", R"(</train>)"};

const Lines kSuite = {R"(<suite name="suite" format="1">)", R"(<vehicle file="wagon.xml"/>)",
                      R"(<scenario file="track.xml"/>)",    R"(<speed from="20 km/h" to="150 km/h" count="14"/>)",
                      R"(<speed value="20 m/s"/>)",         R"(<form name="matrix"/>)",
                      R"(<method name="exact"/>)",          R"(</suite>)"};

const Lines kStudy = {
    R"(<study name="study" format="1" settle="1 s" evaluation="run">)",
    R"(<vehicle file="wagon.xml"/>)",
    R"(<scenario file="track.xml"/>)",
    R"(<vary parameter="secondary.stiffness_z" from="1 MN/m" to="4 MN/m" count="3" spacing="linear"/>)",
    R"(<vary parameter="primary.damping_z" kind="relative" values="80 %, 100 %"/>)",
    R"(<plan kind="latin_hypercube" size="3" seed="1"/>)",
    R"(<design name="light"> <set parameter="carbody.mass" value="50 t"/> </design>)",
    R"(<metric name="carbody.az.rms"/>)",
    R"(<metric name="static.s_front.deflection"/>)",
    R"(<objective metric="carbody.az.rms" goal="minimise" over="worst"/>)",
    R"(<limit metric="static.s_front.deflection" below="90 mm" above="1 mm"/>)",
    R"(</study>)"};

std::string textOf(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// All that `vehicle check` says of a file.
ProblemList problemsOf(const std::string& path) {
  FileSource disk;
  return checkFile(path, disk).problems;
}

/// A file with one thing spoilt.
struct Spoilt {
  std::string name;  // of the file
  Lines lines;
  int line;  // of the mistake
  std::string what;
};

/// Every attribute="value" that a message quotes before its remedy stands so in the file.
void expectQuotesOfTheFile(const Problem& problem, const std::string& text) {
  static const std::regex kQuoted("([A-Za-z_]+)=\"([^\"]*)\"( \\(default\\))?");
  for (std::sregex_iterator each(problem.message.begin(), problem.message.end(), kQuoted), end; each != end; ++each) {
    if ((*each)[3].matched) continue;
    const std::string quoted = (*each)[1].str() + "=\"" + (*each)[2].str() + '"';
    EXPECT_NE(text.find(quoted), std::string::npos) << quoted << " in: " << problem.text();
  }
}

class OneMistake : public ::testing::Test {
 protected:
  OneMistake() {
    for (const auto& [name, lines] : files()) folder_.file(name, textOf(lines));
  }

  static const std::vector<std::pair<std::string, Lines>>& files() {
    static const std::vector<std::pair<std::string, Lines>> kFiles = {{"wagon.xml", kWagon}, {"track.xml", kTrack},
                                                                      {"rig.xml", kRig},     {"train.xml", kTrain},
                                                                      {"suite.xml", kSuite}, {"study.xml", kStudy}};
    return kFiles;
  }

  void expectOneLine(const Spoilt& each) {
    const std::string text = textOf(each.lines);
    // A file that is made anew, for one that is overwritten waits for the disk.
    std::filesystem::remove(folder_.path("spoilt-" + each.name));
    const std::string path = folder_.file("spoilt-" + each.name, text);
    const ProblemList problems = problemsOf(path);
    ASSERT_EQ(problems.size(), 1u) << each.name << ": " << each.what << "\n" << problems.text();
    EXPECT_EQ(problems[0].place.file, path);
    EXPECT_EQ(problems[0].place.line, each.line) << each.what << "\n" << problems.text();
    EXPECT_EQ(problems[0].text().find('\n'), std::string::npos);
    EXPECT_FALSE(problems[0].remedy.empty()) << problems.text();
    expectQuotesOfTheFile(problems[0], text);
    ++tried_;
  }

  /// Calls `spoil` for every attribute of every file; what it returns is put in its place, unless it is the same.
  /// @param spoil  of the attribute's name, its value and ` name="value"` as it stands there
  void forEachAttribute(
      const std::function<std::string(const std::string&, const std::string&, const std::string&)>& spoil) {
    static const std::regex kAttribute(" ([a-z_]+)=\"([^\"]*)\"");
    for (const auto& [name, lines] : files()) {
      for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::sregex_iterator each(lines[i].begin(), lines[i].end(), kAttribute), end; each != end; ++each) {
          const std::string instead = spoil((*each)[1].str(), (*each)[2].str(), each->str());
          if (instead == each->str()) continue;
          Lines changed = lines;
          changed[i].replace(static_cast<std::size_t>(each->position()), each->str().size(), instead);
          expectOneLine({name, changed, static_cast<int>(i) + 1, each->str() + " -> " + instead});
        }
      }
    }
  }

  TestFolder folder_;
  int tried_ = 0;
};

bool isQuantity(const std::string& value) {
  static const std::regex kQuantity("-?[0-9.]+ [A-Za-z].*");
  return std::regex_match(value, kQuantity);
}

TEST_F(OneMistake, TheFilesWithoutHaveNone) {
  for (const auto& [name, lines] : files()) EXPECT_EQ(problemsOf(folder_.path(name)).text(), "") << name;
}

TEST_F(OneMistake, InTheUnitOfAnyQuantity) {
  for (const std::string unit : {"furlong", "", "kg^2", "/m", "kN*"}) {
    forEachAttribute([&](const std::string& attribute, const std::string& value, const std::string& whole) {
      if (!isQuantity(value)) return whole;
      return ' ' + attribute + "=\"" + value.substr(0, value.find(' ') + 1) + unit + '"';
    });
  }
  EXPECT_GT(tried_, 400);
}

TEST_F(OneMistake, InTheNumberOfAnyQuantity) {
  for (const std::string number : {"much", "57,000", "3,5", "nan", "1e999"}) {
    forEachAttribute([&](const std::string& attribute, const std::string& value, const std::string& whole) {
      if (!isQuantity(value)) return whole;
      return ' ' + attribute + "=\"" + number + value.substr(value.find(' ')) + '"';
    });
  }
  EXPECT_GT(tried_, 400);
}

TEST_F(OneMistake, InTheNameOfAnyAttribute) {
  forEachAttribute([&](const std::string& attribute, const std::string&, const std::string& whole) {
    if (attribute.size() < 3) return whole;
    return whole.substr(0, attribute.size() + 1) + 'q' + whole.substr(attribute.size() + 1);  // massq
  });
  EXPECT_GT(tried_, 150);
}

// A required attribute that is left out.
TEST_F(OneMistake, InALeftOutAttribute) {
  std::set<std::string> required;
  const std::function<void(const ElementRow&)> collect = [&](const ElementRow& row) {
    for (const AttributeRow& each : row.attributes) {
      if (each.required) required.emplace(each.name);
    }
    for (const ElementRow& child : row.children) collect(child);
  };
  for (const FileKind kind : allFileKinds()) collect(schemaOf(kind));
  // Of these some elements can do without: an own name of a track's member, a speed of a rig.
  const std::set<std::string> optional = {"from", "to", "count", "name", "value", "spacing", "kind"};
  forEachAttribute([&](const std::string& attribute, const std::string&, const std::string& whole) {
    return required.contains(attribute) && !optional.contains(attribute) ? std::string() : whole;
  });
  EXPECT_GT(tried_, 50);
}

TEST_F(OneMistake, InAnyReference) {
  const std::set<std::string> references = {"element", "upper", "lower", "body", "metric"};
  for (const std::string wrong : {"nowhere", "two words"}) {
    forEachAttribute([&](const std::string& attribute, const std::string&, const std::string& whole) {
      return references.contains(attribute) ? ' ' + attribute + "=\"" + wrong + '"' : whole;
    });
  }
  // A letter too many.
  forEachAttribute([&](const std::string& attribute, const std::string& value, const std::string& whole) {
    return references.contains(attribute) ? ' ' + attribute + "=\"" + value + "x\"" : whole;
  });
  EXPECT_GT(tried_, 60);
}

TEST_F(OneMistake, InAnyChoice) {
  const std::set<std::string> choices = {"motion", "history", "shape", "rail",    "from",
                                         "goal",   "over",    "kind",  "spacing", "evaluation"};
  forEachAttribute([&](const std::string& attribute, const std::string& value, const std::string& whole) {
    const bool is_word = value.find_first_of("0123456789") == std::string::npos;
    return choices.contains(attribute) && is_word ? ' ' + attribute + "=\"zzz\"" : whole;
  });
  EXPECT_GT(tried_, 12);
}

TEST_F(OneMistake, InANameThatIsNone) {
  forEachAttribute([&](const std::string& attribute, const std::string& value, const std::string& whole) {
    if (attribute != "name" || value.find('.') != std::string::npos) return whole;
    return std::string(" name=\"two words\"");
  });
  forEachAttribute([&](const std::string& attribute, const std::string& value, const std::string& whole) {
    const bool on_part = attribute == "name" && value.find('.') == std::string::npos;
    return on_part && value != "hole" && value != "wave" && value != "joint" && value != "rise" && value != "slow" &&
                   value != "fast" && value != "wagon"
               ? std::string()
               : whole;
  });
  EXPECT_GT(tried_, 40);
}

// A name of an element that is misspelt, or that means nothing at all.
TEST_F(OneMistake, InTheNameOfAnyElement) {
  static const std::regex kLeaf("<([a-z_]+)( [^<]*)/>");
  for (const auto& [name, lines] : files()) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::smatch match;
      if (!std::regex_search(lines[i], match, kLeaf)) continue;
      for (const std::string& instead : {match[1].str() + "q", std::string("zzzzzzzz")}) {
        Lines changed = lines;
        changed[i].replace(static_cast<std::size_t>(match.position(1)), match[1].str().size(), instead);
        expectOneLine({name, changed, static_cast<int>(i) + 1, lines[i] + " -> " + instead});
      }
    }
  }
  EXPECT_GT(tried_, 60);
}

// An element that was forgotten: whatever it carries and whoever names it, at most one line.
TEST_F(OneMistake, InALeftOutElement) {
  for (const auto& [name, lines] : files()) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!lines[i].ends_with("/>")) continue;
      Lines changed = lines;
      changed[i] = "";
      std::filesystem::remove(folder_.path("spoilt-" + name));
      const ProblemList problems = problemsOf(folder_.file("spoilt-" + name, textOf(changed)));
      EXPECT_LE(problems.size(), 1u) << lines[i] << '\n' << problems.text();
    }
  }
}

// An element around others that means nothing: what it holds may be what the others name.
TEST_F(OneMistake, InAnElementAroundOthers) {
  for (const std::string lines_of : {"group", "track", "rig", "input", "initial_state"}) {
    for (const auto& [name, lines] : files()) {
      for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!lines[i].starts_with('<' + lines_of)) continue;
        Lines changed = lines;
        changed[i].replace(1, lines_of.size(), "zzzzzzzz");
        std::size_t end = i;
        while (changed[end] != "</" + lines_of + '>') ++end;
        changed[end] = "</zzzzzzzz>";
        expectOneLine({name, changed, static_cast<int>(i) + 1, lines[i]});
      }
    }
  }
  EXPECT_EQ(tried_, 6);
}

// Mistakes in every line of a file make one line each, in one pass.
TEST_F(OneMistake, InEveryLineMakesOneLineEach) {
  static const std::regex kUnit("([0-9]) [A-Za-z][A-Za-z0-9*/^.]*\"");
  for (const auto& [name, lines] : files()) {
    Lines changed = lines;
    std::vector<int> spoilt;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      changed[i] = std::regex_replace(lines[i], kUnit, "$1 furlong\"", std::regex_constants::format_first_only);
      if (changed[i] != lines[i]) spoilt.push_back(static_cast<int>(i) + 1);
    }
    const ProblemList problems = problemsOf(folder_.file("all-" + name, textOf(changed)));
    std::vector<int> found;
    for (const Problem& each : problems) found.push_back(each.place.line);
    EXPECT_EQ(found, spoilt) << problems.text();
    EXPECT_GE(found.size(), 2u);
  }
}

TEST_F(OneMistake, InASign) {
  const std::set<std::string> positive = {"mass",     "hertz_constant", "contact_stiffness", "wavelength", "length",
                                          "duration", "output_step",    "angular_frequency", "frequency",  "spacing",
                                          "end_x",    "fade_in"};
  forEachAttribute([&](const std::string& attribute, const std::string& value, const std::string& whole) {
    const bool may_be = positive.contains(attribute) && isQuantity(value);
    return may_be ? ' ' + attribute + "=\"-" + value + '"' : whole;
  });
  forEachAttribute([&](const std::string& attribute, const std::string& value, const std::string& whole) {
    if (!positive.contains(attribute) || !isQuantity(value)) return whole;
    return ' ' + attribute + "=\"0" + value.substr(value.find(' ')) + '"';
  });
  EXPECT_GT(tried_, 40);
}

}  // namespace
}  // namespace vehicle::test
