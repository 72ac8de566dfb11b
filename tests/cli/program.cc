#include "tests/cli/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/support/source_tree.h"

extern char** environ;

namespace vehicle::test {

namespace {

/// A terminal that the program writes to and the test reads from.
class Terminal {
 public:
  Terminal() : ours_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    std::array<char, 128> name{};
    if (ours_ < 0 || ::grantpt(ours_) != 0 || ::unlockpt(ours_) != 0 ||
        ::ptsname_r(ours_, name.data(), name.size()) != 0) {
      throw std::runtime_error("this system gives no terminal");
    }
    name_ = name.data();
    // Held open until the program has it: a terminal that nobody has open reads as ended.
    theirs_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios plain{};
    ::tcgetattr(theirs_, &plain);
    ::cfmakeraw(&plain);  // a newline stays one
    ::tcsetattr(theirs_, TCSANOW, &plain);
    ::fcntl(ours_, F_SETFL, O_NONBLOCK);
  }
  ~Terminal() {
    ::close(theirs_);
    ::close(ours_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  void setWidth(int columns) const {
    winsize size{};
    size.ws_row = 24;
    size.ws_col = static_cast<unsigned short>(columns);
    ::ioctl(ours_, TIOCSWINSZ, &size);
  }
  /// Appends what is there.
  void readInto(std::string& text) const {
    std::array<char, 4096> block;
    for (ssize_t got = 0; (got = ::read(ours_, block.data(), block.size())) > 0;) {
      text.append(block.data(), static_cast<std::size_t>(got));
    }
  }

 private:
  int ours_ = -1;
  int theirs_ = -1;
  std::string name_;
};

// A shell may have given the tests the width of its terminal.
[[maybe_unused]] const int kNoColumns = ::unsetenv("COLUMNS");

/// Starts the program. Output goes to files, not pipes: nothing can block, whatever it writes.
pid_t start(const std::vector<std::string>& arguments, const std::string& out, const std::string& err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOCTTY, 0600);
  std::vector<std::string> words = {programPath()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  const int failed = posix_spawn(&process, programPath().c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot start " + programPath());
  return process;
}

int statusOf(int state) { return WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state); }

constexpr const char* kEraseLine = "\r\033[K";  // begins every drawing of the bar, and ends the last

/// What stays on a terminal: of each line what follows its last erasing.
std::string withoutProgress(const std::string& terminal) {
  std::istringstream lines(terminal);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t last = line.rfind(kEraseLine);
    const std::string shown = last == std::string::npos ? line : line.substr(last + std::string(kEraseLine).size());
    if (!lines.eof()) {
      text += shown + '\n';
    } else {
      text += shown;
    }
  }
  return text;
}

}  // namespace

std::string programPath() { return VEHICLE_PROGRAM; }

std::string model(const std::string& name) { return sourcePath("models/" + name); }

ProgramRun runVehicle(const std::vector<std::string>& arguments) {
  const TestFolder folder;
  const std::string out = folder.path("out"), err = folder.path("err");
  int state = 0;
  ::waitpid(start(arguments, out, err), &state, 0);
  return {statusOf(state), textOf(out), textOf(err)};
}

Columns::Columns(const std::string& value) { ::setenv("COLUMNS", value.c_str(), 1); }
Columns::~Columns() { ::unsetenv("COLUMNS"); }

ProgramRun runVehicleOnTerminal(const std::vector<std::string>& arguments, int columns) {
  const TestFolder folder;
  const std::string err = folder.path("err");
  const Terminal terminal;
  terminal.setWidth(columns);
  const pid_t process = start(arguments, terminal.name(), err);
  ProgramRun run;
  int state = 0;
  for (bool over = false; !over;) {
    over = ::waitpid(process, &state, WNOHANG) == process;
    terminal.readInto(run.out);  // a terminal that is not read blocks the program
    if (!over) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  terminal.readInto(run.out);
  run.status = statusOf(state);
  run.err = textOf(err);
  return run;
}

bool showsProgress(const RunningProgram& program) { return program.terminal.find(kEraseLine) != std::string::npos; }

namespace {

/// Processor time of a process, of all its threads [s].
double computedBy(pid_t process) {
  std::ifstream stream("/proc/" + std::to_string(process) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  // After the name, which is in parentheses and may hold anything: state, ..., and as the 12th field the user's time.
  std::istringstream fields(text.substr(text.rfind(')') + 1));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  long ticks = 0;
  fields >> ticks;
  return static_cast<double>(ticks) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

constexpr double kForAWhile = 0.1;  // [s] of processor time

}  // namespace

bool hasComputed(const RunningProgram& program) { return computedBy(program.process) > kForAWhile; }

Event hasComputedSince(const std::string& file) {
  return [file, begun = std::optional<double>()](const RunningProgram& program) mutable {
    if (!begun && std::filesystem::exists(file)) begun = computedBy(program.process);
    return begun && computedBy(program.process) > *begun + kForAWhile;
  };
}

ProgramRun runVehicle(const std::vector<std::string>& arguments, const Event& until,
                      const std::function<void(pid_t)>& then) {
  const TestFolder folder;
  const std::string out = folder.path("out");
  const Terminal terminal;
  RunningProgram running{start(arguments, out, terminal.name()), {}};
  int state = 0;
  bool over = false, has_happened = false;
  // A program that hangs is ended after longer than any machine takes.
  const auto hang = std::chrono::steady_clock::now() + std::chrono::minutes(10);
  while (!over) {
    over = ::waitpid(running.process, &state, WNOHANG) == running.process;
    terminal.readInto(running.terminal);
    if (!over && !has_happened && until(running)) {
      has_happened = true;
      then(running.process);
    }
    if (std::chrono::steady_clock::now() > hang) ::kill(running.process, SIGKILL);
    if (!over) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  terminal.readInto(running.terminal);
  return {statusOf(state), textOf(out), withoutProgress(running.terminal)};
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
