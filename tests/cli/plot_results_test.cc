// The examples of docs/how-to/plot-results.md, run as they stand there by the tools that this machine has.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cli/studies.h"
#include "tests/support/source_tree.h"

namespace vehicle::test {
namespace {

/// The code between "```<title>" and "```".
std::string exampleOf(const std::string& title) {
  const std::string page = textOf(sourcePath("docs/how-to/plot-results.md"));
  const std::string begin = "```" + title + "\n";
  const std::size_t at = page.find(begin);
  if (at == std::string::npos) throw std::invalid_argument("the page has no example " + title);
  return page.substr(at + begin.size(), page.find("```", at + begin.size()) - at - begin.size());
}

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

/// The numbers of a column of a CSV file without quotes.
std::vector<double> columnOf(const std::string& csv, const std::string& name) {
  const std::vector<std::string> lines = linesOf(csv);
  const std::vector<std::string> names = fieldsOf(lines.front());
  const auto place = std::find(names.begin(), names.end(), name);
  if (place == names.end()) throw std::invalid_argument("no column " + name);
  std::vector<double> column;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    column.push_back(std::stod(fieldsOf(lines[i])[static_cast<std::size_t>(place - names.begin())]));
  }
  return column;
}

double largestIn(const std::vector<double>& column) {
  double largest = 0.0;
  for (const double each : column) largest = std::max(largest, std::abs(each));
  return largest;
}

class PlotResults : public testing::Test {
 protected:
  PlotResults() {
    EXPECT_EQ(runVehicle({"simulate", model("vehicles/al-oraiqat-2017.xml"), model("scenarios/paper-20mps.xml"),
                          "--output", path("run.csv"), "--output", path("run.h5")})
                  .status,
              0);
    EXPECT_EQ(runVehicle({"study", model("studies/stiffness-and-damping.xml"), "--output", path("sweep.sqlite"),
                          "--export", path("sweep.csv")})
                  .status,
              0);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

  /// Runs the code with a line behind it that prints how many points are plotted, and the largest |x| and |y|.
  void expectPlotted(const std::string& command, const std::string& code, const std::string& x_name,
                     const std::string& y_name, const std::string& csv, double factor) const {
    folder_.file("example", code);
    const std::string line = "cd '" + path("") + "' && " + command + " > out 2> err";
    ASSERT_EQ(std::system(line.c_str()), 0) << code << textOf(path("out")) << textOf(path("err"));
    std::istringstream said(textOf(path("out")));
    std::size_t points = 0;
    double x = 0.0, y = 0.0;
    ASSERT_TRUE(said >> points >> x >> y) << textOf(path("out")) << textOf(path("err"));
    const std::vector<double> expected = columnOf(textOf(path(csv)), y_name);
    EXPECT_EQ(points, expected.size());
    // Both read the same digits; 17 of them are printed.
    EXPECT_DOUBLE_EQ(x, largestIn(columnOf(textOf(path(csv)), x_name)));
    EXPECT_DOUBLE_EQ(y, factor * largestIn(expected));
  }
  void expectHistory(const std::string& command, const std::string& code) const {
    expectPlotted(command, code, "time [s]", "carbody.z [m]", "run.csv", 1e3);
  }
  void expectStudy(const std::string& command, const std::string& code) const {
    expectPlotted(command, code, "secondary_front.deflection.peak @ 72 km/h [m]", "carbody.az.rms @ 72 km/h [m/s^2]",
                  "sweep.csv", 1.0);
  }

 private:
  TestFolder folder_;
};

#if defined(VEHICLE_OCTAVE_DRAWS) || defined(VEHICLE_MATLAB)
/// Lines are looked up in the picture itself, which no screen shows.
std::string watched(const std::string& code) {
  return "set(0, 'defaultfigurevisible', 'off');\n" + code +
         "points = get(gca, 'children'); x = get(points(1), 'xdata'); y = get(points(1), 'ydata');\n"
         "fprintf('%d %.17g %.17g\\n', numel(x), max(abs(x)), max(abs(y)));\n";
}
#endif

#ifdef VEHICLE_OCTAVE
// A stand-in records what is plotted: what the examples read is tried without a graphics toolkit too.
std::string recordedByOctave() {
  return VEHICLE_OCTAVE " --norc --quiet --path '" + sourcePath("tests/cli/recorder/octave") + "' example";
}

TEST_F(PlotResults, OctaveReadsAHistory) { expectHistory(recordedByOctave(), exampleOf("octave history")); }
TEST_F(PlotResults, OctaveReadsAStudy) { expectStudy(recordedByOctave(), exampleOf("octave study")); }
#endif

#ifdef VEHICLE_OCTAVE_DRAWS
constexpr const char* kOctave = VEHICLE_OCTAVE " --norc --quiet example";

TEST_F(PlotResults, OctaveDrawsAHistory) { expectHistory(kOctave, watched(exampleOf("octave history"))); }
TEST_F(PlotResults, OctaveDrawsAStudy) { expectStudy(kOctave, watched(exampleOf("octave study"))); }
#endif

#ifdef VEHICLE_MATLAB
constexpr const char* kMatlab = "cp example example_of_page.m && " VEHICLE_MATLAB " -batch example_of_page";

TEST_F(PlotResults, MatlabReadsAHistory) { expectHistory(kMatlab, watched(exampleOf("matlab history"))); }
TEST_F(PlotResults, MatlabReadsAStudy) { expectStudy(kMatlab, watched(exampleOf("matlab study"))); }
#endif

#ifdef VEHICLE_PYTHON
std::string watchedPython(const std::string& code) {
  return code +
         "x, y = plt.gca().lines[0].get_data()\n"
         "print(len(x), repr(float(max(map(abs, x)))), repr(float(max(map(abs, y)))))\n";
}

// A stand-in records what is plotted: what the examples read is tried without Matplotlib too.
std::string recorded() { return "PYTHONPATH='" + sourcePath("tests/cli/recorder") + "' " VEHICLE_PYTHON " -B example"; }

TEST_F(PlotResults, PythonReadsAHistory) { expectHistory(recorded(), watchedPython(exampleOf("python csv"))); }
TEST_F(PlotResults, PythonReadsAStudy) { expectStudy(recorded(), watchedPython(exampleOf("python study"))); }
#endif

#ifdef VEHICLE_MATPLOTLIB
constexpr const char* kDrawn = "MPLBACKEND=Agg " VEHICLE_PYTHON " -B example";

TEST_F(PlotResults, MatplotlibDrawsAHistory) { expectHistory(kDrawn, watchedPython(exampleOf("python csv"))); }
TEST_F(PlotResults, MatplotlibDrawsAStudy) { expectStudy(kDrawn, watchedPython(exampleOf("python study"))); }
#endif

#if defined(VEHICLE_MATPLOTLIB) && defined(VEHICLE_H5PY)
TEST_F(PlotResults, MatplotlibDrawsAHistoryOfHdf5) { expectHistory(kDrawn, watchedPython(exampleOf("python hdf5"))); }
#endif

}  // namespace
}  // namespace vehicle::test
