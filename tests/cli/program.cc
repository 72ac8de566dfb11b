#include "tests/cli/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <thread>

extern char** environ;

namespace vehicle::test {

std::string model(const std::string& name) { return std::string(VEHICLE_SOURCE_DIR) + "/models/" + name; }

ProgramRun runVehicle(const std::vector<std::string>& arguments, const std::function<void(int)>& while_running,
                      std::chrono::milliseconds delay) {
  // Files, not pipes: nothing can block, whatever the program writes.
  const TestFolder folder;
  const std::string out = folder.path("out"), err = folder.path("err");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  std::vector<std::string> words = {VEHICLE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  const int failed = posix_spawn(&process, VEHICLE_PROGRAM, &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot start " VEHICLE_PROGRAM);
  if (while_running) {
    std::this_thread::sleep_for(delay);
    while_running(process);
  }
  int state = 0;
  waitpid(process, &state, 0);
  return {WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state), textOf(out), textOf(err)};
}

std::string smallVehicle() {
  return R"(<vehicle name="small" format="1">
  <element name="spring" stiffness_z="1 MN/m" damping_z="20 kN*s/m"/>
  <body name="carbody" mass="10 t" motion="z"/>
  <wheelset name="wheelset" x="0 m"/>
  <suspension name="suspension" element="spring" upper="carbody" lower="wheelset" x="0 m"/>
</vehicle>
)";
}

std::string smallScenario(const std::string& run) {
  return "<scenario name=\"waves\" format=\"1\">\n  <run " + run +
         "/>\n  <track history=\"onset\">\n    <harmonic wavelength=\"25 m\" amplitude=\"5 mm\"/>\n  "
         "</track>\n</scenario>\n";
}

}  // namespace vehicle::test
