#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <tinyxml2.h>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/xml/schema.h"

namespace vehicle {

/// Fills a definition from a tree of elements by walking the schema table, and goes on after every problem.
///
/// What is misspelt is reported and then read as what was meant. What has a wrong value, is missing or is not understood
/// is reported and marked in the part's Origin, so that one mistake makes one message and definition's check() can judge
/// the rest.
class PartReader {
 public:
  explicit PartReader(std::string file) : file_(std::move(file)) {}

  /// @param root    an element that `row` describes
  /// @param object  the struct that `row` is bound to
  void read(const tinyxml2::XMLElement& root, const ElementRow& row, void* object);

  /// False where nothing is known of the file's meaning: it is of another format.
  [[nodiscard]] bool isReadable() const { return readable_; }
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
  /// The attributes of one element on their way into its struct.
  struct Attributes {
    const tinyxml2::XMLElement& element;
    const ElementRow& row;
    void* object;
    const std::string& path;
    PartText text = {};
    std::set<std::string, std::less<>> given = {};  // also those that were meant by a misspelt one
  };

  PartText readAttributes(const tinyxml2::XMLElement& element, const ElementRow& row, void* object,
                          const std::string& path);
  void readOne(const tinyxml2::XMLAttribute& attribute, const AttributeRow& row, Attributes& of);
  bool readMisspelt(const tinyxml2::XMLAttribute& attribute, Attributes& of);
  void readStandingFor(Attributes& of);
  void addMissing(bool something_strange, Attributes& of);
  void readChildren(const tinyxml2::XMLElement& element, const Scope& scope);
  void readChild(const tinyxml2::XMLElement& child, const ElementRow& row, const Scope& scope);
  void readText(const tinyxml2::XMLElement& element, const ElementRow& row, std::string& text, const std::string& path);
  const ElementRow* rowFor(const tinyxml2::XMLElement& child, const Scope& scope);
  void addStrange(const tinyxml2::XMLElement& element);
  void report(int line, const std::string& path, std::string message, std::string remedy);

  std::string file_;
  ProblemList problems_;
  std::vector<std::string> strange_words_;  // values inside elements that were not understood
  bool has_strange_ = false;
  bool readable_ = true;
};

}  // namespace vehicle
