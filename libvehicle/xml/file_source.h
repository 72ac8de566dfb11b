#pragma once

#include <map>
#include <string>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

/// The files of a piece of work, each read once: whoever asks for a path again gets the text of the first reading. So
/// what a result keeps as its inputs is what it was made from, whatever happens to the files meanwhile.
class FileSource {
 public:
  /// Reads from disk: regular files of at most 256 MiB. Devices, pipes and folders are refused, since reading them may
  /// never end.
  FileSource() = default;
  /// Holds these texts and reads nothing.
  /// @param texts  by path; a path leads to the same text however it is spelt ("a/../b.xml")
  explicit FileSource(const std::map<std::string, std::string>& texts);

  /// Holds a text under a name from now on, as if it had been read from there (standard input has no path).
  void hold(const std::string& path, std::string text);

  /// The text of a file, or the problem that prevented reading it. Valid as long as the source.
  [[nodiscard]] const Outcome<std::string>& text(const std::string& path);

 private:
  [[nodiscard]] std::string keyOf(const std::string& path) const;

  bool reads_disk_ = true;
  std::map<std::string, Outcome<std::string>> known_;  // by keyOf(path)
};

}  // namespace vehicle
