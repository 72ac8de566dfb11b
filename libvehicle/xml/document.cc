#include "libvehicle/xml/document.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/xml/text_guard.h"

namespace vehicle {

namespace {

Outcome<std::string> refuse(const std::string& path, std::string message, std::string remedy) {
  Outcome<std::string> outcome;
  outcome.problems.add({{path, 0}, "", std::move(message), std::move(remedy)});
  return outcome;
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
