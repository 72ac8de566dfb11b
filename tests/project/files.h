#pragma once

#include <string>

#include "tests/support/test_folder.h"
#include "tests/xml/files.h"

// A folder with the smallest right file of each kind, which name each other: v.xml, t.xml, s.xml, u.xml, study.xml.
namespace vehicle::test {

class ProjectFolder {
 public:
  ProjectFolder() {
    put("v.xml", textOf(kVehicleLines));
    put("t.xml", textOf(kTrainLines));
    put("s.xml", textOf(kScenarioLines));
    put("u.xml", withLine(kSuiteLines, 5, R"(<form name="matrix"/>)"));
    put("study.xml", textOf(kStudyLines));
  }
  std::string put(const std::string& name, const std::string& text) const { return folder_.file(name, text); }
  std::string path(const std::string& name) const { return folder_.path(name); }

  /// Messages with the folder's own path left out.
  std::string withoutFolder(std::string text) const {
    const std::string prefix = folder_.path("");
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      text.erase(at, prefix.size());
    }
    return text;
  }

 private:
  TestFolder folder_;
};

}  // namespace vehicle::test
