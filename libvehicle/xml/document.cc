#include "libvehicle/xml/document.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/xml/message_text.h"
#include "libvehicle/xml/text_guard.h"

namespace vehicle {

namespace {

Outcome<std::string> refuse(const std::string& path, std::string message, std::string remedy) {
  Outcome<std::string> outcome;
  outcome.problems.add({{path, 0}, "", std::move(message), std::move(remedy)});
  return outcome;
}

/// What tinyxml2 found, in words for the person who wrote the file. Its own words name its own source.
std::string wordsFor(tinyxml2::XMLError error, const std::string& element) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return element.empty() ? "a closing tag stands without its opening tag"
                             : fmt::format("<{0}> is not closed by </{0}>", element);
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE: return "an attribute is not of the form name=\"value\"";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return fmt::format("elements stand more than {} deep in each other", TINYXML2_MAX_ELEMENT_DEPTH);
    case tinyxml2::XML_ERROR_PARSING: return "an element is not closed before the end of the file";
    default: return "this is not well-formed XML";
  }
}

/// "... XMLElement name=body" -> "body": tinyxml2 tells the element only inside its message.
std::string elementIn(const char* message) {
  const std::string text = message != nullptr ? message : "";
  constexpr std::string_view kKey = "XMLElement name=";
  const std::size_t at = text.rfind(kKey);
  return at == std::string::npos ? "" : shown(text.substr(at + kKey.size()));
}

}  // namespace

Outcome<std::string> readText(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    const std::string reason = error ? error.message() : std::strerror(ENOENT);
    return refuse(path, fmt::format("cannot be read: {}", reason), "check the name of the file");
  }
  if (std::filesystem::is_directory(status)) {
    return refuse(path, "is a folder", "name a file in it");
  }
  if (!std::filesystem::is_regular_file(status)) {
    return refuse(path, "is no regular file", "copy what it gives into a file");
  }
  std::string text;
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file != nullptr) {
    std::array<char, 16384> block;
    std::size_t got = 0;
    // One byte more than allowed is enough to know that the file is too large.
    while (text.size() <= kMostBytes && (got = std::fread(block.data(), 1, block.size(), file)) > 0) {
      text.append(block.data(), got);
    }
  }
  const bool failed = file == nullptr || std::ferror(file) != 0;
  const int reason = errno;
  if (file != nullptr) std::fclose(file);
  if (failed) return refuse(path, fmt::format("cannot be read: {}", std::strerror(reason)), "check its permissions");
  return {std::move(text), {}};
}

Document parseDocument(std::string_view text, const std::string& file_name) {
  Document document;
  document.problems = guardText(text, file_name);
  if (!document.problems.empty()) return document;

  document.tree = std::make_unique<tinyxml2::XMLDocument>();
  tinyxml2::XMLDocument& tree = *document.tree;
  const auto report = [&](int line, std::string message, std::string remedy) {
    document.problems.add({{file_name, line}, "", std::move(message), std::move(remedy)});
  };
  const tinyxml2::XMLError error = tree.Parse(text.data(), text.size());
  if (error != tinyxml2::XML_SUCCESS && error != tinyxml2::XML_ERROR_EMPTY_DOCUMENT) {
    report(tree.ErrorLineNum(), wordsFor(error, elementIn(tree.ErrorStr())),
           "an XML editor or xmllint shows the place");
    return document;
  }
  const tinyxml2::XMLElement* root = tree.RootElement();
  if (root == nullptr) {
    report(0, "the file holds no element", "write e.g. <vehicle name=\"coach\" format=\"1\"> ... </vehicle>");
    return document;
  }
  for (const tinyxml2::XMLNode* node = tree.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() != nullptr) {
      report(node->GetLineNum(), fmt::format("the text \"{}\" stands outside the root element", shown(node->Value())),
             "remove it");
    } else if (node->ToElement() != nullptr && node != root) {
      report(node->GetLineNum(), fmt::format("a second root element <{}> stands after <{}>", shown(node->Value()),
                                             shown(root->Value())),
             "one file holds one");
      break;
    }
  }
  if (document.problems.empty()) document.root = root;
  return document;
}

}  // namespace vehicle
