#include "libvehicle/simulate/run_notes.h"

#include <algorithm>
#include <utility>

#include "libvehicle/simulate/stiffness.h"
#include "libvehicle/simulate/thread_choice.h"

namespace vehicle {
namespace {

/// Why threads that were left open became one; "" where more could share the run.
std::string unsharedNote(const RunChoice& choice, const RunResult& result) {
  constexpr int kSeveral = 2;
  if (choice.sharing.threads != 0 || canBeShared(result.form, result.method)) return {};
  return "--threads auto is one thread: " + threadsUnsupported(result.form, result.method, {.threads = kSeveral});
}

void addNew(std::string note, std::vector<std::string>& notes) {
  const bool is_new = std::find(notes.begin(), notes.end(), note) == notes.end();
  if (!note.empty() && is_new) notes.push_back(std::move(note));
}

}  // namespace

std::vector<std::string> notesOn(const CompiledModel& model, const Scenario& scenario, const RunChoice& choice,
                                 const RunResult& result) {
  std::vector<std::string> notes = result.notes;
  addNew(unsharedNote(choice, result), notes);
  addNew(stiffnessNote(model, scenario, choice, result), notes);
  return notes;
}

std::vector<std::string> notesOn(const CompiledModel& model, const Scenario& scenario, const RunChoice& choice,
                                 const std::vector<RunResult>& runs) {
  std::vector<std::string> notes;
  for (const RunResult& run : runs) {
    for (const std::string& note : run.notes) addNew(note, notes);
    RunChoice own = choice;
    own.speed = run.speed;
    addNew(stiffnessNote(model, scenario, own, run), notes);
  }
  if (!runs.empty()) addNew(unsharedNote(choice, runs.front()), notes);
  return notes;
}

}  // namespace vehicle
