#pragma once

namespace vehicle::cli {

/// What the program tells the shell; every --help says the same.
enum ExitStatus : int {
  kDone = 0,
  kInputIsWrong = 1,        // a file that is read: vehicle, scenario, suite, study or its database
  kCommandLineIsWrong = 2,  // an option, a file name to write to
  kRunFailed = 3,           // started and could not be finished or stored
  kCheckDidNotHold = 4,     // validate: a pair outside its expected size; --strict: a warning
  kInterrupted = 130,       // Ctrl-C (128 + SIGINT as shells count), SIGTERM or SIGHUP; what was done is saved
};

/// What follows "Exit status: ".
inline constexpr const char* kExitStatusHelp =
    "0 done; 1 an input file is wrong; 2 this command line is wrong; 3 the run failed;\n"
    "4 a check did not hold, or with --strict a warning was given;\n"
    "130 interrupted by Ctrl-C, SIGTERM or SIGHUP, what was done is saved.";

}  // namespace vehicle::cli
