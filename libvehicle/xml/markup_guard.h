#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

/// Elements stand at most so deep in each other; our files need five.
inline constexpr std::size_t kMostDepth = 32;

/// More attributes than any element of ours has. tinyxml2 compares each with all before it: a megabyte of them
/// would take minutes.
inline constexpr std::size_t kMostAttributes = 64;

/// Walks once through a text from markup to markup and holds it against XML 1.0: tags of the right form that
/// open and close in pairs below one root, attributes once each and in quotation marks, comments and CDATA
/// closed, no entities but the five of XML, and neither document types nor processing instructions but <?xml-model?>,
/// by which editors find a schema.
///
/// Goes on after what is wrong by itself, and ends where the rest could no longer be understood.
class MarkupGuard {
 public:
  MarkupGuard(std::string_view text, const std::string& file_name) : text_(text), file_(file_name) {}

  /// @param begin  first byte of the markup, behind byte order mark and declaration
  [[nodiscard]] ProblemList run(std::size_t begin);

  /// Bytes [from, to) that mean nothing to this program: <?xml-model ...?>.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& ignored() const { return ignored_; }

 private:
  struct OpenTag {
    std::string_view name;
    int line;
  };

  void report(std::size_t offset, std::string message, std::string remedy);
  int lineAt(std::size_t offset);
  void passCharacter();
  bool passMarkup();
  bool passUntil(std::string_view close, std::size_t opening, std::string_view name);
  bool passInstruction();
  bool passSection();
  bool passComment();
  bool passClosingTag();
  bool passOpeningTag();
  bool passAttribute(std::string_view element, std::string_view name);
  std::string_view passName();
  void passSpaces();
  [[nodiscard]] char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;       // next byte to look at
  std::size_t counted_ = 0;  // bytes whose lines are in line_
  int line_ = 1;
  std::vector<OpenTag> open_;
  std::string_view root_;  // empty before the root element
  ProblemList problems_;
  std::vector<std::pair<std::size_t, std::size_t>> ignored_;
};

}  // namespace vehicle
