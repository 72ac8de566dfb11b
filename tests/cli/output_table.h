#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/cli/studies.h"

// Every output of every command, and files to try it on.
namespace vehicle::test {

/// An option that names a file or folder to write, in a command that works but for that file.
struct Output {
  const char* name;
  const char* command;  // its first word
  const char* option;
  const char* ending;              // of its files; "" for a folder
  std::vector<std::string> words;  // the command without the option; files are in the folder of the test
};

/// Files of a small vehicle, a train of it, a study, a list of designs and a finished study.
class OutputFiles {
 public:
  OutputFiles() {
    static_cast<void>(smallStudyIn(folder_));
    folder_.file("short.xml", smallScenario(R"(speed="20 m/s" duration="50 ms" output_step="5 ms")"));
    folder_.file("train.xml",
                 R"(<train name="pair" format="1"><vehicle file="v.xml" count="2" spacing="12 m"/></train>)");
    folder_.file("list.csv", "spring.stiffness_z [N/m]\n1e6\n");
    folder_.file("listed.xml", with(with(smallStudy(), R"(<vary parameter="speed" values="20 m/s, 108 km/h"/>)", ""),
                                    "<design name=\"soft\"",
                                    "<plan kind=\"list\" file=\"list.csv\"/>\n  <design "
                                    "name=\"soft\""));
    // The named designs would be undone by the list.
    listed_ =
        with(textOf(path("listed.xml")), "spring.stiffness_z\" value=\"0.5 MN/m\"", "carbody.mass\" value=\"9 t\"");
    folder_.file("listed.xml", listed_);
    static const std::string done = [this] {
      EXPECT_EQ(runVehicle({"study", path("study.xml"), "--output", path("done.sqlite"), "--quiet"}).status, 0);
      return textOf(path("done.sqlite"));
    }();
    folder_.file("done.sqlite", done);
  }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }
  std::string file(const std::string& name, const std::string& text) const { return folder_.file(name, text); }

  /// Names and texts of all files: what a refused command must not change.
  [[nodiscard]] std::map<std::string, std::string> all() const {
    std::map<std::string, std::string> texts;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.root())) {
      texts[entry.path().string()] = entry.is_regular_file() ? textOf(entry.path().string()) : "";
    }
    return texts;
  }

  [[nodiscard]] ProgramRun run(const Output& output, const std::vector<std::string>& more) const {
    std::vector<std::string> words = {output.command};
    for (const std::string& word : output.words) {
      words.push_back(word.find('.') != std::string::npos ? path(word) : word);
    }
    words.insert(words.end(), more.begin(), more.end());
    return runVehicle(words);
  }

 private:
  TestFolder folder_;
  std::string listed_;
};

inline std::vector<Output> outputs() {
  return {
      {"simulate --output .csv", "simulate", "--output", ".csv", {"train.xml", "short.xml"}},
      {"simulate --output .h5", "simulate", "--output", ".h5", {"train.xml", "short.xml"}},
      {"profile --trace", "profile", "--trace", ".json", {"v.xml", "short.xml", "--threads", "1"}},
      {"profile --timeline", "profile", "--timeline", ".svg", {"v.xml", "short.xml", "--threads", "1"}},
      {"study --output", "study", "--output", ".sqlite", {"listed.xml"}},
      {"study --export", "study", "--export", ".csv", {"listed.xml", "--output", "new.sqlite"}},
      {"study --write-best", "study", "--write-best", "", {"study.xml", "--output", "new.sqlite"}},
      {"study show --export", "study", "--export", ".csv", {"show", "done.sqlite"}},
      {"study show --write-best", "study", "--write-best", "", {"show", "done.sqlite"}},
  };
}

/// The files that the command reads, and what it would write beside the output at hand.
inline std::vector<std::string> keptBy(const Output& output) {
  const std::string name = output.name;
  if (name.starts_with("simulate")) return {"train.xml", "v.xml", "short.xml"};
  if (name.starts_with("profile")) return {"v.xml", "short.xml"};
  if (name.starts_with("study show")) {
    return {"done.sqlite", "done.sqlite-wal", "done.sqlite-shm", "done.sqlite-journal", "done.sqlite-lock"};
  }
  std::vector<std::string> kept = {"v.xml", "s.xml"};
  if (name == "study --write-best") return {"v.xml", "s.xml", "study.xml", "new.sqlite", "new.sqlite-wal"};
  kept.insert(kept.end(), {"listed.xml", "list.csv"});
  if (name == "study --export") kept.insert(kept.end(), {"new.sqlite", "new.sqlite-wal", "new.sqlite-lock"});
  return kept;
}

/// Where the output would be written: the file, or in a folder one of its files.
inline std::string placeOf(const OutputFiles& files, const Output& output) {
  return *output.ending != '\0' ? files.path(std::string("out") + output.ending) : files.path("carbody-az-rms-1.xml");
}
inline std::string argumentFor(const OutputFiles& files, const Output& output) {
  return *output.ending != '\0' ? placeOf(files, output)
                                : std::filesystem::path(placeOf(files, output)).parent_path().string();
}

}  // namespace vehicle::test
