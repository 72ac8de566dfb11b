#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/support/test_folder.h"

namespace vehicle::test {

/// build/.../bin/vehicle, as an absolute path.
[[nodiscard]] std::string programPath();

/// What a run of the program `vehicle` left behind.
struct ProgramRun {
  int status = -1;  // exit status; 128 + signal if one killed it
  std::string out;
  std::string err;  // without the progress bar
};

/// Runs build/.../bin/vehicle with these arguments, stdout and stderr apart, no terminal.
[[nodiscard]] ProgramRun runVehicle(const std::vector<std::string>& arguments);

/// The same with stdout on a terminal of that many columns.
[[nodiscard]] ProgramRun runVehicleOnTerminal(const std::vector<std::string>& arguments, int columns);

/// While it lives, programs that start find COLUMNS in their environment. Elsewhere they do not, whatever shell runs the
/// tests.
class Columns {
 public:
  explicit Columns(const std::string& value);
  ~Columns();
  Columns(const Columns&) = delete;
  Columns& operator=(const Columns&) = delete;
};

/// What can be seen of the program while it runs.
struct RunningProgram {
  pid_t process = 0;
  std::string terminal;  // all that it has written to its stderr so far
};
/// Whether something has happened that a test waits for.
using Event = std::function<bool(const RunningProgram&)>;

/// The progress bar is drawn: the run, study or validation is under way.
[[nodiscard]] bool showsProgress(const RunningProgram& program);
/// It has been computing for a while, however long a busy machine took to let it.
[[nodiscard]] bool hasComputed(const RunningProgram& program);
/// A file is there, and the program has been computing since: designs of a study, whose database that is.
[[nodiscard]] Event hasComputedSince(const std::string& file);

/// The same with its stderr on a terminal; once something has happened `then` is called with the process id, unless the
/// program ended before. Waits for the event and for nothing else, so that any machine will do.
[[nodiscard]] ProgramRun runVehicle(const std::vector<std::string>& arguments, const Event& until,
                                    const std::function<void(pid_t)>& then);

/// models/..., as an absolute path.
[[nodiscard]] std::string model(const std::string& name);

/// A vehicle file of two bodies' worth: one body on one wheelset, enough for every command.
[[nodiscard]] std::string smallVehicle();
/// @param run  attributes of <run>, e.g. R"(speed="20 m/s" duration="1 s" output_step="5 ms")"
[[nodiscard]] std::string smallScenario(const std::string& run);

}  // namespace vehicle::test
