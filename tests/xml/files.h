#pragma once

#include <string>
#include <vector>

// The smallest right file of each kind, line by line, so that a test may spoil one line.
namespace vehicle::test {

using Lines = std::vector<std::string>;

inline const Lines kVehicleLines = {
    R"(<vehicle name="v" format="1">)",
    R"(  <element name="primary" stiffness_z="3040 kN/m" damping_z="30 kN*s/m"/>)",
    R"(  <body name="frame" mass="9 t" motion="z"/>)",
    R"(  <wheelset name="axle" x="1 m"/>)",
    R"(  <suspension name="spring" element="primary" upper="frame" lower="axle" x="1 m"/>)",
    R"(</vehicle>)",
};

inline const Lines kTrainLines = {
    R"(<train name="t" format="1">)",
    R"(  <vehicle file="v.xml" count="3" spacing="26 m"/>)",
    R"(  <coupling stiffness_z="50 kN/m" damping_z="20 kN*s/m" end_x="12.5 m"/>)",
    R"(</train>)",
};

inline const Lines kScenarioLines = {
    R"(<scenario name="s" format="1">)",
    R"(  <run speed="20 m/s" duration="10 s" output_step="5 ms"/>)",
    R"(  <track history="onset">)",
    R"(    <harmonic wavelength="25 m" amplitude="5 mm"/>)",
    R"(  </track>)",
    R"(</scenario>)",
};

inline const Lines kRigLines = {
    R"(<scenario name="s" format="1">)",
    R"(  <run duration="10 s"/>)",
    R"(  <rig>)",
    R"(    <input wheelset="axle"><sine amplitude="6 mm" angular_frequency="5 rad/s"/></input>)",
    R"(  </rig>)",
    R"(</scenario>)",
};

inline const Lines kSuiteLines = {
    R"(<suite name="u" format="1">)",
    R"(  <vehicle file="v.xml"/>)",
    R"(  <scenario file="s.xml"/>)",
    R"(  <speed from="20 km/h" to="150 km/h" count="14"/>)",
    R"(  <form name="flat"/>)",
    R"(  <method name="exact"/>)",
    R"(</suite>)",
};

inline const Lines kStudyLines = {
    R"(<study name="d" format="1">)",
    R"(  <vehicle file="v.xml"/>)",
    R"(  <scenario file="s.xml"/>)",
    R"(  <vary parameter="primary.stiffness_z" from="2 MN/m" to="4 MN/m" count="3"/>)",
    R"(  <plan kind="grid"/>)",
    R"(  <metric name="frame.az.rms"/>)",
    R"(  <objective metric="frame.az.rms" goal="minimise"/>)",
    R"(  <limit metric="frame.az.rms" below="1 m/s^2"/>)",
    R"(</study>)",
};

inline std::string textOf(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// The lines with another text in line `line`, counted from 1.
inline Lines withLines(Lines lines, int line, const std::string& instead) {
  lines.at(static_cast<std::size_t>(line - 1)) = instead;
  return lines;
}

/// The same as a text.
inline std::string withLine(const Lines& lines, int line, const std::string& instead) {
  return textOf(withLines(lines, line, instead));
}

/// One line of a file spoilt, and all that the program says about it.
struct Spoilt {
  int line;
  const char* instead;
  const char* says;
};

}  // namespace vehicle::test
