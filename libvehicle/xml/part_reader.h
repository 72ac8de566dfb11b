#pragma once

#include <set>
#include <string>
#include <vector>

#include <tinyxml2.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/xml/schema.h"

namespace vehicle {

/// Fills a definition from a tree of elements by walking the schema table, and goes on after every problem.
///
/// What is misspelt is told and then read as what was meant, and what has a wrong value is told and then has
/// some value in range: so one mistake makes one message, and definition's check() can judge the rest.
class PartReader {
 public:
  explicit PartReader(std::string file) : file_(std::move(file)) {}

  /// @param root    an element that `row` describes
  /// @param object  the struct that `row` is bound to
  void read(const tinyxml2::XMLElement& root, const ElementRow& row, void* object);

  /// False where parts are missing in a way that would make check() talk about their absence.
  [[nodiscard]] bool isComplete() const { return complete_; }
  [[nodiscard]] ProblemList takeProblems() { return std::move(problems_); }

 private:
  /// Where the walk stands: what the table says may be here, and whom it fills.
  struct Scope {
    const ElementRow& row;     // the element whose children are read
    void* object;              // its struct
    std::string path;          // of that element, e.g. "<scenario><track>"
    const ElementRow* holder;  // inside a group: the group's parent, whose elements may stand here; else null
    void* holder_object;
    std::string group;  // name of that group
  };

  void readAttributes(const tinyxml2::XMLElement& element, const ElementRow& row, void* object,
                      const std::string& path);
  void readOne(const tinyxml2::XMLAttribute& attribute, const AttributeRow& row, const ElementRow& element_row,
               void* object, const std::string& path);
  void reportMissing(const tinyxml2::XMLElement& element, const ElementRow& row, void* object,
                     const std::set<std::string>& given, const std::string& path);
  void readChildren(const tinyxml2::XMLElement& element, const Scope& scope);
  void readChild(const tinyxml2::XMLElement& child, const ElementRow& row, const Scope& scope);
  void readText(const tinyxml2::XMLElement& element, const ElementRow& row, std::string& text, const std::string& path);
  const ElementRow* rowFor(const tinyxml2::XMLElement& child, const Scope& scope);
  void report(int line, const std::string& path, std::string message, std::string remedy);

  std::string file_;
  ProblemList problems_;
  bool complete_ = true;
};

}  // namespace vehicle
