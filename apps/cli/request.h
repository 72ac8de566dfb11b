#pragma once

#include <string>
#include <vector>

namespace vehicle::cli {

/// What a command line asks for, before a command reads its words.
struct Request {
  enum class Kind {
    kRun,
    kHelp,
    kVersion
  };
  Kind kind = Kind::kRun;
  std::string command = {};             // of kHelp; "" for the page of the program
  std::vector<std::string> words = {};  // of kRun: the command, then its options and files
};

/// Help and version may be asked for anywhere on the line: -h, --help, --version, `help`, `help COMMAND`, and
/// `COMMAND help` where no file is called so; the first of them counts. What every command takes (--format, --quiet,
/// -q, --strict) may stand before the command too.
/// @param words     the command line without the program's name
/// @param commands  names of all commands
[[nodiscard]] Request requestOf(const std::vector<std::string>& words, const std::vector<std::string>& commands);

}  // namespace vehicle::cli
