#include "libvehicle/xml/document.h"

#include <utility>

#include "libvehicle/xml/text_guard.h"

namespace vehicle {

Document parseDocument(std::string_view text, const std::string& file_name) {
  Document document;
  const GuardedText guarded = guardText(text, file_name);
  document.problems = guarded.problems;
  if (!document.problems.empty()) return document;

  document.tree = std::make_unique<tinyxml2::XMLDocument>();
  tinyxml2::XMLDocument& tree = *document.tree;
  const auto report = [&](int line, std::string message, std::string remedy) {
    document.problems.add({{file_name, line}, "", std::move(message), std::move(remedy)});
  };
  const tinyxml2::XMLError error = tree.Parse(guarded.text.data(), guarded.text.size());
  if (error != tinyxml2::XML_SUCCESS && error != tinyxml2::XML_ERROR_EMPTY_DOCUMENT) {
    // The guard is stricter than tinyxml2, so nobody has seen this line; it stands for the case that they differ.
    report(tree.ErrorLineNum(), "this is not well-formed XML", "an XML editor or xmllint shows the place");
    return document;
  }
  const tinyxml2::XMLElement* root = tree.RootElement();
  if (root == nullptr) {
    report(0, "the file holds no element", "write e.g. <vehicle name=\"coach\" format=\"1\"> ... </vehicle>");
    return document;
  }
  document.root = root;
  return document;
}

}  // namespace vehicle
