#include "apps/cli/study_best.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "libvehicle/storage/atomic_file.h"
#include "libvehicle/xml/writer.h"

namespace vehicle::cli {
namespace {

/// What names of vehicles and files are made of.
std::string plainName(std::string text) {
  std::replace_if(text.begin(), text.end(),
                  [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-'; }, '-');
  return text;
}

class BestWriter {
 public:
  BestWriter(const std::string& folder, const StudyInputs& inputs) : folder_(folder), inputs_(inputs) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) throw RunFailed(fmt::format("folder {}: {}", folder, error.message()));
  }

  void write(const JudgedDesign& design, const std::string& name) {
    Vehicle vehicle = inputs_.vehicle;
    std::vector<Scenario> scenarios = inputs_.scenarios;
    apply(inputs_.bound, design.parameters, vehicle, scenarios);
    vehicle.name = plainName(inputs_.vehicle.name + "-" + name);
    vehicle.title = fmt::format("{}{}design {} of the study {}", vehicle.title, vehicle.title.empty() ? "" : "; ", design.id,
                                inputs_.study.name);
    const std::string path = (folder_ / (name + ".xml")).string();
    AtomicFile file(path);
    file.write(vehicle::write(vehicle));
    file.publish();
    written_.push_back(path);
  }
  std::vector<std::string> take() { return std::move(written_); }

 private:
  std::filesystem::path folder_;
  const StudyInputs& inputs_;
  std::vector<std::string> written_;
};

}  // namespace

std::vector<std::string> writeBest(const std::string& folder, const StudySummary& summary, const StudyInputs& inputs) {
  if (!inputs.vehicle.units.empty()) {
    throw std::invalid_argument("--write-best: the study's vehicle is a train; its designs are no vehicle files");
  }
  BestWriter writer(folder, inputs);
  for (std::size_t i = 0; i < summary.best.size(); ++i) {
    const std::string objective = plainName(inputs.bound.metrics[inputs.bound.objectives[i].metric].metric.name);
    for (std::size_t rank = 0; rank < summary.best[i].size(); ++rank) {
      writer.write(summary.best[i][rank], fmt::format("{}-{}", objective, rank + 1));
    }
  }
  if (summary.best.empty()) {
    for (const JudgedDesign& each : summary.compared) {
      if (each.id > 0 && each.id < inputs.bound.designs.size()) writer.write(each, plainName(each.name));
    }
  }
  return writer.take();
}

}  // namespace vehicle::cli
