#include "apps/cli/study_best.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "apps/cli/study_best_train.h"
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
  BestWriter(std::filesystem::path folder, const StudyWork& work) : folder_(std::move(folder)), work_(work) {}

  void write(const JudgedDesign& design, const std::string& wanted) {
    std::string name = wanted;
    // Two objectives of one metric want the same name.
    for (int number = 2; !names_.insert(name).second; ++number) name = fmt::format("{}_{}", wanted, number);
    const StudyInputs& inputs = work_.inputs;
    Vehicle vehicle = inputs.vehicle;
    std::vector<Scenario> scenarios = inputs.scenarios;
    apply(inputs.bound, design.parameters, vehicle, scenarios);
    if (!work_.train) {
      return store(named(std::move(vehicle), design, name), name + ".xml");
    }
    const Train train = trainOf(*work_.train, inputs.vehicle, vehicle, name);
    for (const TrainVehicle& each : train.vehicles) store(each.vehicle, each.file);
    store(named(train, design, name), name + ".xml");
  }
  std::vector<std::string> take() { return std::move(written_); }

 private:
  template <class Owner>
  Owner named(Owner owner, const JudgedDesign& design, const std::string& name) const {
    owner.name = plainName(owner.name + "-" + name);
    if (!owner.title.empty()) owner.title += "; ";
    owner.title += fmt::format("design {} of the study {}", design.name, work_.inputs.study.name);
    return owner;
  }

  template <class Owner>
  void store(const Owner& owner, const std::string& name) {
    const std::string path = (folder_ / name).string();
    AtomicFile file(path);
    file.write(vehicle::write(owner));
    file.publish();
    written_.push_back(path);
  }

  std::filesystem::path folder_;
  const StudyWork& work_;
  std::set<std::string> names_;
  std::vector<std::string> written_;
};

}  // namespace

void requireFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RunFailed(fmt::format("{}: the folder cannot be made: {}", folder, error.message()));
  const AtomicFile probe(std::filesystem::path(folder) / "best.xml");
}

std::vector<std::string> writeBest(const std::string& folder, const StudySummary& summary, const StudyWork& work) {
  const BoundStudy& bound = work.inputs.bound;
  BestWriter writer(folder, work);
  for (std::size_t i = 0; i < summary.best.size(); ++i) {
    const std::string objective = plainName(bound.metrics[bound.objectives[i].metric].metric.name);
    for (std::size_t rank = 0; rank < summary.best[i].size(); ++rank) {
      writer.write(summary.best[i][rank], fmt::format("{}-{}", objective, rank + 1));
    }
  }
  if (summary.best.empty()) {
    for (const JudgedDesign& each : summary.compared) {
      if (each.id > 0 && each.id < bound.designs.size()) writer.write(each, plainName(each.name));
    }
  }
  return writer.take();
}

}  // namespace vehicle::cli
