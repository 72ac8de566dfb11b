#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/cli/program.h"

// Studies as files, and their numbers by hand.
namespace vehicle::test {

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// `text` with the first `old` replaced; one that is not there ends the test.
inline std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::invalid_argument("\"" + old + "\" is not in the text");
  return text.replace(at, old.size(), now);
}

inline std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// What follows the last line that begins with `title`, up to an empty line.
inline std::string tableCalled(const std::string& title, const std::string& text) {
  const std::size_t at = text.find("\n" + title);
  if (at == std::string::npos) return "no table " + title + " in\n" + text;
  return text.substr(at + 1, text.find("\n\n", at + 1) - at);
}

/// smallVehicle() in v.xml: 10 t on 1 MN/m and 20 kN*s/m, over smallScenario() in s.xml, with two other springs.
inline std::string smallStudy() {
  return R"(<study name="springs" format="1" evaluation="steady_state">
  <vehicle file="v.xml"/>
  <scenario file="s.xml"/>
  <vary parameter="speed" values="20 m/s, 108 km/h"/>
  <design name="soft"><set parameter="spring.stiffness_z" value="0.5 MN/m"/></design>
  <design name="damped"><set parameter="spring.damping_z" value="40 kN*s/m"/></design>
  <metric name="carbody.az.rms"/>
  <metric name="static.suspension.deflection"/>
  <objective metric="carbody.az.rms" goal="minimise"/>
  <limit metric="static.suspension.deflection" below="150 mm"/>
</study>
)";
}

/// Writes the small study with its files.
/// @returns the path of the study
inline std::string smallStudyIn(const TestFolder& folder, const std::string& text = smallStudy()) {
  folder.file("v.xml", smallVehicle());
  folder.file("s.xml", smallScenario(R"(speed="20 m/s" duration="1 s" output_step="5 ms")"));
  return folder.file("study.xml", text);
}

/// R.m.s. acceleration [m/s^2] of 10 t on a spring and damper over waves of 25 m and 5 mm in the steady state:
/// w^2 a |k + i c w| / |k - m w^2 + i c w| / sqrt(2).   A. K. Chopra, Dynamics of Structures, (3.6.5)
/// @param k  [N/m], @param c  [N s/m], @param speed  [m/s]
inline double rmsOfSmall(double k, double c, double speed) {
  const double w = 2.0 * std::numbers::pi * speed / 25.0;
  const std::complex<double> spring(k, c * w);
  return w * w * 5e-3 * std::abs(spring / (spring - 1e4 * w * w)) / std::sqrt(2.0);
}

/// Static deflection [m] of 10 t under 9.81 m/s^2.
inline double sagOfSmall(double k) { return 1e4 * 9.81 / k; }

/// A study of the paper's vehicle whose designs are quick.
/// @param vary  the <vary> elements and the <plan>
inline std::string paperStudy(const std::string& vary,
                              const std::string& metrics = R"(<metric name="carbody.az.rms"/>)") {
  return "<study name=\"paper\" format=\"1\" evaluation=\"steady_state\">\n  <vehicle file=\"" +
         model("vehicles/al-oraiqat-2017.xml") + "\"/>\n  <scenario file=\"" +
         model("scenarios/paper-20mps-extended.xml") + "\"/>\n  " + vary + "\n  " + metrics + "\n</study>\n";
}

}  // namespace vehicle::test
