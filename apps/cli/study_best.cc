#include "apps/cli/study_best.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "apps/cli/study_best_train.h"
#include "libvehicle/storage/atomic_file.h"
#include "libvehicle/storage/output_folder.h"
#include "libvehicle/storage/output_kind.h"
#include "libvehicle/xml/writer.h"

namespace vehicle::cli {
namespace {

/// What names of vehicles and files are made of.
std::string plainName(std::string text) {
  std::replace_if(text.begin(), text.end(),
                  [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-'; }, '-');
  return text;
}

/// The files of one design, of a train those that its vehicles may need.
std::vector<std::string> filesOf(const std::string& name, const StudyWork& work) {
  std::vector<std::string> files = {name + ".xml"};
  if (!work.train) return files;
  for (const TrainUnit& each : work.inputs.vehicle.units) files.push_back(name + "-" + each.name + ".xml");
  return files;
}

/// Texts of files, all written before the first takes its name.
class FileSet {
 public:
  void add(const std::filesystem::path& path, const std::string& text) { texts_.emplace_back(path, text); }
  [[nodiscard]] bool empty() const { return texts_.empty(); }

  [[nodiscard]] std::vector<std::string> write() const {
    std::vector<std::unique_ptr<AtomicFile>> files;
    for (const auto& [path, text] : texts_) {
      AtomicFile& file = *files.emplace_back(std::make_unique<AtomicFile>(path));
      file.write(text);
      file.finish();
    }
    std::vector<std::string> written;
    for (std::size_t i = 0; i < files.size(); ++i) {
      files[i]->publish();
      written.push_back(texts_[i].first.string());
    }
    return written;
  }

 private:
  std::vector<std::pair<std::filesystem::path, std::string>> texts_;
};

class BestWriter {
 public:
  BestWriter(std::filesystem::path folder, const StudyWork& work) : folder_(std::move(folder)), work_(work) {}

  void add(const JudgedDesign& design, const std::string& name) {
    const StudyInputs& inputs = work_.inputs;
    Vehicle vehicle = inputs.vehicle;
    std::vector<Scenario> scenarios = inputs.scenarios;
    apply(inputs.bound, design.parameters, vehicle, scenarios);
    if (!work_.train) return addFile(named(std::move(vehicle), design, name), name + ".xml");
    const Train train = trainOf(*work_.train, assembled(*work_.train), vehicle, name);
    for (const TrainVehicle& each : train.vehicles) addFile(each.vehicle, each.file);
    addFile(named(train, design, name), name + ".xml");
  }
  [[nodiscard]] const FileSet& files() const { return files_; }

 private:
  template <class Owner>
  Owner named(Owner owner, const JudgedDesign& design, const std::string& name) const {
    owner.name = plainName(owner.name + "-" + name);
    if (!owner.title.empty()) owner.title += "; ";
    owner.title += fmt::format("design {} of the study {}", design.name, work_.inputs.study.name);
    return owner;
  }

  template <class Owner>
  void addFile(const Owner& owner, const std::string& name) {
    files_.add(folder_ / name, fmt::format("{}\n{}", kVehicleMark, vehicle::write(owner)));
  }

  std::filesystem::path folder_;
  const StudyWork& work_;
  FileSet files_;
};

}  // namespace

BestNames::BestNames(const StudyWork& work, std::size_t best) {
  std::set<std::string> taken;
  // Two objectives of one metric ask for the same name, and so may a design and a vehicle of a train.
  const auto unique = [&](const std::string& wanted) {
    std::string name = wanted;
    const auto is_taken = [&](const std::string& file) { return taken.contains(file); };
    std::vector<std::string> files = filesOf(name, work);
    for (int number = 2; std::any_of(files.begin(), files.end(), is_taken); ++number) {
      name = fmt::format("{}_{}", wanted, number);
      files = filesOf(name, work);
    }
    taken.insert(files.begin(), files.end());
    return name;
  };
  const BoundStudy& bound = work.inputs.bound;
  for (const BoundObjective& each : bound.objectives) {
    const std::string objective = plainName(bound.metrics[each.metric].metric.name);
    std::vector<std::string>& ranks = of_objectives_.emplace_back();
    for (std::size_t rank = 1; rank <= best; ++rank) ranks.push_back(unique(fmt::format("{}-{}", objective, rank)));
  }
  if (!bound.objectives.empty()) return;
  for (std::size_t i = 1; i < bound.designs.size(); ++i)
    of_designs_.push_back(unique(plainName(bound.designs[i].name)));
}

std::vector<std::string> BestNames::all() const {
  std::vector<std::string> names = of_designs_;
  for (const std::vector<std::string>& each : of_objectives_) names.insert(names.end(), each.begin(), each.end());
  return names;
}

std::vector<std::string> filesOfBest(const BestNames& names, const StudyWork& work) {
  std::vector<std::string> files;
  for (const std::string& name : names.all()) {
    const std::vector<std::string> own = filesOf(name, work);
    files.insert(files.end(), own.begin(), own.end());
  }
  return files;
}

std::vector<std::string> writeBest(const std::string& folder, const StudySummary& summary, const StudyWork& work,
                                   const BestNames& names) {
  BestWriter writer(folder, work);
  for (std::size_t i = 0; i < summary.best.size(); ++i) {
    for (std::size_t rank = 0; rank < summary.best[i].size(); ++rank) {
      writer.add(summary.best[i][rank], names.ofRank(i, rank));
    }
  }
  if (summary.best.empty()) {
    for (const JudgedDesign& each : summary.compared) {
      if (each.id > 0 && each.id < work.inputs.bound.designs.size()) writer.add(each, names.ofNamed(each.id));
    }
  }
  if (!writer.files().empty()) makeFolder(folder);
  return writer.files().write();
}

}  // namespace vehicle::cli
