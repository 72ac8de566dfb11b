// Runs are written as they go: the same bytes as from memory, in memory that does not grow with the run.
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/project/run_files.h"
#include "libvehicle/simulate/forms.h"
#include "libvehicle/storage/csv.h"
#include "libvehicle/storage/hdf5.h"
#include "libvehicle/track/rail_piece.h"
#include "tests/support/own_process.h"
#include "tests/support/source_tree.h"
#include "tests/support/test_folder.h"
#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

using test::TestFolder;
using test::textOf;

Model modelOf(const TestFolder& folder, const std::string& run) {
  const std::string scenario = "<scenario name=\"s\" format=\"1\">\n  <run " + run +
                               "/>\n  <track history=\"onset\">\n    <harmonic wavelength=\"25 m\" amplitude=\"5 "
                               "mm\"/>\n    <dip shape=\"half_sine\" depth=\"3 mm\" "
                               "length=\"2 m\" start=\"7 m\"/>\n  </track>\n</scenario>\n";
  FileSource disk;
  return readModel(test::sourcePath("models/vehicles/al-oraiqat-2017.xml"), folder.file("s.xml", scenario), disk);
}

RunResult stored(const Model& model, const RunChoice& choice) {
  return simulate(model.vehicle, model.scenario, choice);
}

TEST(RunStreams, FilesAreThoseOfTheHistoryInMemory) {
  for (const char* method : {"exact", "rk4", "dopri5"}) {
    const TestFolder folder;
    const Model model = modelOf(folder, R"(speed="20 m/s" duration="20.003 s" output_step="7 ms")");
    RunChoice choice;
    choice.method = method;
    const RunResult result = stored(model, choice);
    const std::string csv = folder.path("streamed.csv"), hdf5 = folder.path("streamed.h5");
    const RunResult streamed = simulateAndStore(model, choice, {{csv, hdf5}, "0.1.0"});
    EXPECT_EQ(streamed.history.samples(), 0u);
    EXPECT_EQ(streamed.history.columns(), result.history.columns());
    EXPECT_EQ(streamed.outputs, static_cast<long>(result.history.samples()));
    const RunDescription description = descriptionOf(model, choice, streamed, "0.1.0");
    writeCsv(result.history, folder.path("stored.csv"));
    writeHdf5({result.history, description.attributes, description.inputs}, folder.path("stored.h5"));
    EXPECT_TRUE(textOf(csv) == textOf(folder.path("stored.csv"))) << method;
    EXPECT_TRUE(textOf(hdf5) == textOf(folder.path("stored.h5"))) << method;
  }
}

TEST(RunStreams, ARunThatIsEndedKeepsWhatItHas) {
  const TestFolder folder;
  const Model model = modelOf(folder, R"(speed="20 m/s" duration="100 s" output_step="5 ms")");
  RunChoice choice;
  const RunResult whole = stored(model, choice);
  const std::string csv = folder.path("run.csv"), hdf5 = folder.path("run.h5");
  const RunResult ended =
      simulateAndStore(model, choice, {{csv, hdf5}, "0.1.0"}, [](double share) { return share < 0.4; });
  ASSERT_TRUE(ended.statistics.stopped);
  const TimeHistory kept = readCsv(csv).orThrow();
  const RunRecord record = readHdf5(hdf5).orThrow();
  EXPECT_EQ(kept.samples(), record.history.samples());
  EXPECT_EQ(kept.at(kept.samples() - 1, 0), ended.reached);
  EXPECT_GT(kept.samples(), 7000u);
  EXPECT_LT(kept.samples(), 9000u);
  // A whole file's beginning.
  writeCsv(whole.history, folder.path("whole.csv"));
  EXPECT_TRUE(textOf(folder.path("whole.csv")).starts_with(textOf(csv)));
}

TEST(RunStreams, ARunThatFailsWritesNothing) {
  const TestFolder folder;
  const Model model = modelOf(folder, R"(speed="20 m/s" duration="100 s" output_step="100 ms")");
  RunChoice choice;
  choice.method = "rk4";
  choice.step = 0.1;  // grows beyond all numbers
  EXPECT_THROW((void)simulateAndStore(model, choice, {{folder.path("run.csv"), folder.path("run.h5")}, "0.1.0"}),
               RunFailed);
  EXPECT_EQ(folder.entries(), 1u);  // the scenario
}

/// Peak of the memory of a process of its own that does that [bytes].
double peakOf(const std::function<void()>& work) {
  const std::optional<rusage> usage = test::usageOf(work);
  EXPECT_TRUE(usage.has_value());
  return usage ? 1024.0 * static_cast<double>(usage->ru_maxrss) : 0.0;
}

// Ten times the run, with both files: in memory its history would take 48 MB more. Allowed: what the C library and HDF5 keep
// in their pools.
TEST(RunStreams, MemoryDoesNotGrowWithTheRun) {
  const TestFolder folder;
  const auto run = [&](const char* duration) {
    const Model model = modelOf(folder, fmt::format(R"(speed="20 m/s" duration="{}" output_step="5 ms")", duration));
    return peakOf([&] {
      (void)simulateAndStore(model, {}, {{folder.path("run.csv"), folder.path("run.h5")}, "0.1.0"});
    });
  };
  const double brief = run("100 s");
  const double longer = run("1000 s");
  EXPECT_LT(longer - brief, 12e6);
  EXPECT_GT(static_cast<double>(textOf(folder.path("run.h5")).size()), 45e6);
}

// 1e6 samples, 1 cm apart, under four wheels for 499 s: the samples take 8 MB, before the run and at its end, and the blocks
// about the wheels one; a segment a sample and wheel would take 2 GB. Allowed on top: the pools of the C library.
TEST(RunStreams, ASampledRailCostsItsSamplesAndNoMore) {
  std::vector<double> heights(1'000'000);
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = 1e-3 * std::sin(0.01 * static_cast<double>(i) * 0.6);
  const CompiledModel model = compile(test::paperVehicle(), 9.81);
  const std::unique_ptr<System> system = buildForm("matrix", model);
  const auto run = [&](double duration) {
    return peakOf([&] {
      const auto samples = std::make_shared<StoredSamples>(heights);
      const auto rail = std::make_shared<SampledRail>(samples, SampleGridOverDistance{0.0, 0.01});
      const Input input = inputOf(piecesOf(rail), model.topology, Travel(20.0), {duration, 5e-3});
      const Schedule schedule(input, 5e-3);
      const std::vector<double> x0(static_cast<std::size_t>(system->size()), 0.0);
      const Statistics statistics = runRk4({*system, input, schedule, x0}, {1e-3}, [](auto&&...) { return true; });
      if (statistics.steps < static_cast<long>(900.0 * duration)) throw std::runtime_error("too few steps");
    });
  };
  const double brief = run(1.0);
  const double whole = run(499.0);
  EXPECT_LT(whole - brief, 4e6);
}

}  // namespace
}  // namespace vehicle
