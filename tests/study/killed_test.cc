#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <new>
#include <random>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "libvehicle/study/runner.h"
#include "tests/study/inputs.h"
#include "tests/support/test_folder.h"

namespace vehicle {
namespace {

using namespace test;

Study sweep() {
  Study study = studyOf({range("secondary.stiffness_z", "1 MN/m", "4 MN/m"), range("carbody.mass", "40 t", "60 t"),
                         list("speed", "20 m/s, 25 m/s, 31 m/s")},
                        {"carbody.az.rms", "rear_bogie.az.rms"});
  study.evaluation = Evaluation::kSteadyState;
  study.plan.emplace();
  study.plan->kind = PlanKind::kSobol;
  study.plan->size = 60'000;
  return study;
}

/// What a child process says of its progress: memory that both see.
class SharedCount {
 public:
  SharedCount() {
    void* memory =
        ::mmap(nullptr, sizeof(std::atomic<std::uint64_t>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("no memory to share");
    count_ = new (memory) std::atomic<std::uint64_t>(0);
  }
  ~SharedCount() { ::munmap(count_, sizeof *count_); }
  SharedCount(const SharedCount&) = delete;
  SharedCount& operator=(const SharedCount&) = delete;
  std::atomic<std::uint64_t>& operator*() const { return *count_; }

 private:
  std::atomic<std::uint64_t>* count_ = nullptr;
};

// A process of its own runs the study and is killed after a random share of it, again and again; whatever was left,
// resuming gives the table of a run that nobody disturbed.
TEST(StudyRunner, AStudyKilledAtAnyMomentIsResumedToTheSameTable) {
  const TestFolder folder;
  const StudyInputs inputs = inputsOf(sweep(), paperVehicle(), {paperScenario(History::kExtended)});
  const DesignPlan plan = DesignPlan::of(inputs.study, inputs.bound).orThrow();
  const SharedCount done;
  const auto run = [&](const std::string& file) {
    StudyTarget target;
    target.database = folder.path(file);
    target.resume = true;
    target.program = "vehicle 0.1.0";
    target.inputs = {{"study.xml", "<study/>"}};
    ThreadExecutor executor(2);
    return runStudy(inputs, plan, target, executor, [&](const StudyProgress& progress) {
      *done = progress.before + progress.evaluated;
      return true;
    });
  };
  const auto table = [&](const std::string& file) {
    StudyDatabase::read(folder.path(file)).writeCsv(folder.path("table.csv"));
    return textOf(folder.path("table.csv"));
  };
  run("whole");
  const std::string reference = table("whole");
  ASSERT_GT(reference.size(), 1'000'000u);

  constexpr int kKills = 20;
  std::mt19937_64 random(4);
  std::uint64_t partly = 0;
  for (int i = 0; i < kKills; ++i) {
    const std::string file = "killed-" + std::to_string(i);
    // Twice: the second child is killed while it goes on.
    for (int child = 0; child < 2; ++child) {
      const auto awaited = static_cast<std::uint64_t>(std::uniform_real_distribution<>(0.0, 0.9)(random) *
                                                      static_cast<double>(plan.size()));
      *done = 0;
      const pid_t process = ::fork();
      ASSERT_GE(process, 0);
      if (process == 0) {
        try {
          run(file);
        } catch (...) {
          ::_exit(1);
        }
        ::_exit(0);
      }
      int status = 0;
      bool over = false;
      while (!over && *done < awaited) {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        over = ::waitpid(process, &status, WNOHANG) == process;
      }
      ::kill(process, SIGKILL);
      if (!over) ::waitpid(process, &status, 0);
      ASSERT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0) << "the child failed by itself";
    }
    const StudyOutcome outcome = run(file);
    partly += outcome.progress.before > 0 && outcome.progress.evaluated > 0 ? 1 : 0;
    ASSERT_TRUE(table(file) == reference) << "kill " << i;
  }
  EXPECT_GT(partly, 0u);  // or no kill has met a run half done, and nothing was tested
}

}  // namespace
}  // namespace vehicle
