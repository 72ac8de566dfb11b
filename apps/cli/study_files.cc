#include "apps/cli/study_files.h"

#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/storage/read_file.h"
#include "libvehicle/xml/reader.h"

namespace vehicle::cli {
namespace {

namespace fs = std::filesystem;

/// Reads one file after another and gathers what is wrong.
class Gatherer {
 public:
  explicit Gatherer(const std::string& study) : folder_(fs::absolute(study).lexically_normal().parent_path()) {}

  template <class T>
  std::optional<T> take(Outcome<T> outcome) {
    problems_.append(outcome.problems);
    return std::move(outcome.value);
  }

  /// Keeps the text of a file, once. Why there is none, its reader tells.
  void keep(const std::string& path) {
    const std::string name = fs::absolute(path).lexically_normal().lexically_relative(folder_).string();
    if (!kept_.insert(name).second) return;
    const Outcome<std::string> text = readFile(path);
    if (text.value) texts_.push_back({name, *text.value});
  }

  void requireNone() {
    if (!problems_.empty()) throw InvalidInput(std::move(problems_));
  }
  std::vector<InputFile> takeTexts() { return std::move(texts_); }

 private:
  fs::path folder_;
  ProblemList problems_;
  std::set<std::string> kept_;
  std::vector<InputFile> texts_;
};

/// A folder that is gone with the object.
class PassingFolder {
 public:
  PassingFolder() {
    std::string name = (fs::temp_directory_path() / "vehicle-study-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw RunFailed("no folder for the files of the study: " + name);
    folder_ = name;
  }
  ~PassingFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return folder_; }

 private:
  fs::path folder_;
};

}  // namespace

StudyWork readStudyWork(const std::string& file) {
  Gatherer gather(file);
  gather.keep(file);
  std::optional<Study> study = gather.take(readStudy(file));
  gather.requireNone();

  StudyInputs inputs;
  const std::string vehicle_file = resolvePath(file, study->vehicle.file);
  gather.keep(vehicle_file);
  std::optional<Vehicle> vehicle = gather.take(readVehicle(vehicle_file));
  // A train's vehicles stand in other files.
  std::optional<Train> train;
  if (vehicle && !vehicle->units.empty()) {
    for (const Body& body : vehicle->bodies) gather.keep(body.origin.file);
    train = gather.take(readTrain(vehicle_file));
  }
  for (const FileReference& named : study->scenarios) {
    const std::string path = resolvePath(file, named.file);
    gather.keep(path);
    if (std::optional<Scenario> scenario = gather.take(readScenario(path))) inputs.scenarios.push_back(*scenario);
  }
  std::string list_file;
  std::string list_text;
  if (study->plan && study->plan->kind == PlanKind::kList) {
    list_file = resolvePath(file, study->plan->file);
    gather.keep(list_file);
    list_text = gather.take(readFile(list_file)).value_or("");
  }
  gather.requireNone();

  std::vector<std::string> listed;
  if (!list_file.empty()) listed = listedAddresses(list_text, list_file).orThrow();
  inputs.vehicle = std::move(*vehicle);
  inputs.bound = bindStudy(*study, inputs.vehicle, inputs.scenarios, listed).orThrow();
  inputs.study = std::move(*study);
  DesignList list;
  if (!list_file.empty()) list = readDesignList(list_text, list_file, inputs.bound).orThrow();
  DesignPlan plan = DesignPlan::of(inputs.study, inputs.bound, std::move(list)).orThrow();
  return {std::move(inputs), std::move(train), std::move(plan), gather.takeTexts()};
}

StudyWork restoreStudyWork(const StudyRecord& record) {
  // Deep enough that names like ../../vehicles/coach.xml stay inside.
  const PassingFolder passing;
  std::ptrdiff_t up = 0;
  for (const InputFile& each : record.inputs) {
    const fs::path name = fs::path(each.name).lexically_normal();
    up = std::max(up, std::count(name.begin(), name.end(), fs::path("..")));
  }
  fs::path folder = passing.path() / "study";
  for (; up > 0; --up) folder /= "in";
  fs::create_directories(folder);
  for (const InputFile& each : record.inputs) {
    const fs::path place = (folder / each.name).lexically_normal();
    const fs::path inside = place.lexically_relative(passing.path());
    if (inside.empty() || *inside.begin() == "..") {
      throw RunFailed(
          fmt::format("the file {} of the study cannot be laid out again; its name leads elsewhere", each.name));
    }
    fs::create_directories(place.parent_path());
    std::ofstream(place, std::ios::binary) << each.text;
  }
  if (record.inputs.empty()) throw RunFailed("the database holds no study file");
  return readStudyWork((folder / record.inputs.front().name).lexically_normal().string());
}

ProblemList asSeenFromHere(const ProblemList& problems, const std::string& study_file) {
  ProblemList seen;
  for (Problem problem : problems) {
    if (!problem.place.file.empty()) {
      problem.place.file = (fs::path(study_file).parent_path() / problem.place.file).lexically_normal().string();
    }
    seen.add(std::move(problem));
  }
  return seen;
}

}  // namespace vehicle::cli
