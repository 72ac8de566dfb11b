#include "libvehicle/xml/markup_guard.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/xml/message_text.h"
#include "libvehicle/xml/text_guard.h"

namespace vehicle {

namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Of names beyond ASCII only UTF-8 is asked: the schema table knows none of them anyway.
bool beginsName(char c) { return isLetter(c) || c == '_' || c == ':' || static_cast<unsigned char>(c) >= 0x80; }
bool goesOnName(char c) { return beginsName(c) || (c >= '0' && c <= '9') || c == '-' || c == '.'; }

/// "amp" -> true, "#215" -> true, "chassis" -> false.
bool isAllowedReference(std::string_view name) {
  constexpr std::array<std::string_view, 5> kPredefined = {"amp", "lt", "gt", "quot", "apos"};
  if (std::find(kPredefined.begin(), kPredefined.end(), name) != kPredefined.end()) return true;
  if (name.size() < 2 || name[0] != '#') return false;
  const bool hexadecimal = name[1] == 'x';
  const std::string_view digits = name.substr(hexadecimal ? 2 : 1);
  std::uint32_t code = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, hexadecimal ? 16 : 10);
  return error == std::errc{} && !digits.empty() && end == digits.data() + digits.size() && isXmlCharacter(code);
}

}  // namespace

ProblemList MarkupGuard::run(std::size_t begin) {
  at_ = begin;
  while (at_ < text_.size()) {
    if (problems_.size() > kMostProblems) return std::move(problems_);
    if (here() != '<' && open_.empty() && !isSpace(here())) {
      const std::string_view rest = text_.substr(at_, text_.find_first_of("<\r\n", at_) - at_);
      report(at_, fmt::format("the text \"{}\" stands outside the root element", shown(rest)), "remove it");
      return std::move(problems_);
    }
    if (text_.substr(at_, 3) == "]]>") {
      report(at_, "\"]]>\" stands in a text", "write \"]]&gt;\"");
      at_ += 3;
    } else if (here() != '<') {
      passCharacter();
    } else if (!passMarkup()) {
      return std::move(problems_);
    }
  }
  // The innermost alone: closing it shows whether the others are closed.
  if (!open_.empty()) {
    const OpenTag& last = open_.back();
    problems_.add({{file_, last.line},
                   "",
                   fmt::format("<{}> is not closed before the end of the file", shown(last.name)),
                   fmt::format("close it with </{}>", shown(last.name))});
  }
  return std::move(problems_);
}

int MarkupGuard::lineAt(std::size_t offset) {
  // Offsets mostly grow, so lines are counted on from the last one asked for.
  if (offset < counted_) {
    counted_ = 0;
    line_ = 1;
  }
  line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                                       text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
  counted_ = offset;
  return line_;
}

void MarkupGuard::report(std::size_t offset, std::string message, std::string remedy) {
  if (problems_.size() > kMostProblems) return;
  const Place place{file_, lineAt(offset)};
  if (problems_.size() == kMostProblems) {
    problems_.add(tooMany(place));
  } else {
    problems_.add({place, "", std::move(message), std::move(remedy)});
  }
}

void MarkupGuard::passCharacter() {
  if (here() == '&') {
    // Longer names than this are no reference that is allowed.
    const std::string_view rest = text_.substr(at_ + 1, 40);
    const std::size_t end = rest.find_first_of("; \t\r\n<>\"'&=");
    if (end == std::string_view::npos || rest[end] != ';' || end == 0) {
      report(at_, "\"&\" stands alone", "write \"&amp;\"");
    } else if (!isAllowedReference(rest.substr(0, end))) {
      report(at_, fmt::format("the entity \"&{};\" is not allowed", rest.substr(0, end)), "write what it stands for");
    }
  }
  ++at_;
}

bool MarkupGuard::passMarkup() {
  const std::string_view rest = text_.substr(at_);
  if (rest.substr(0, 4) == "<!--") return passComment();
  if (rest.substr(0, 9) == "<![CDATA[") return passSection();
  if (rest.substr(0, 2) == "<!") {
    report(at_, "document types and entity declarations (\"<!\") are not allowed",
           "remove it; the program knows its files without");
    return false;
  }
  if (rest.substr(0, 2) == "<?") return passInstruction();
  return rest.substr(0, 2) == "</" ? passClosingTag() : passOpeningTag();
}

bool MarkupGuard::passUntil(std::string_view close, std::size_t opening, std::string_view name) {
  const std::size_t end = text_.find(close, at_ + opening);
  if (end == std::string_view::npos) {
    report(at_, fmt::format("\"{}\" is not closed", name), fmt::format("close it with \"{}\"", close));
    return false;
  }
  at_ = end + close.size();
  return true;
}

bool MarkupGuard::passInstruction() {
  const std::size_t begin = at_;
  constexpr std::string_view kModel = "<?xml-model";
  const std::string_view rest = text_.substr(at_);
  const bool names_schema = rest.starts_with(kModel) && rest.size() > kModel.size() && isSpace(rest[kModel.size()]);
  if (names_schema && open_.empty()) {
    if (!passUntil("?>", 2, "<?")) return false;
    ignored_.emplace_back(begin, at_);
    return true;
  }
  report(at_, "processing instructions (\"<?\") are not allowed here",
         "only <?xml version=\"1.0\" encoding=\"UTF-8\"?> may stand, at the very beginning, and <?xml-model ...?> "
         "outside the root element");
  return passUntil("?>", 2, "<?");
}

bool MarkupGuard::passSection() {
  if (!open_.empty()) return passUntil("]]>", 9, "<![CDATA[");
  report(at_, "\"<![CDATA[\" stands outside the root element", "remove it");
  return false;
}

bool MarkupGuard::passComment() {
  const std::size_t begin = at_;
  if (!passUntil("-->", 4, "<!--")) return false;
  const std::string_view inside = text_.substr(begin + 4, at_ - 3 - (begin + 4));
  if (inside.find("--") != std::string_view::npos || (!inside.empty() && inside.back() == '-')) {
    report(begin, "\"--\" stands inside a comment", "XML ends comments there; write \"-\"");
  }
  return true;
}

void MarkupGuard::passSpaces() {
  while (isSpace(here())) ++at_;
}

std::string_view MarkupGuard::passName() {
  const std::size_t begin = at_;
  if (!beginsName(here())) return {};
  while (goesOnName(here())) ++at_;
  return text_.substr(begin, at_ - begin);
}

bool MarkupGuard::passClosingTag() {
  const std::size_t begin = at_;
  at_ += 2;
  const std::string_view name = passName();
  passSpaces();
  if (name.empty() || here() != '>') {
    report(begin, fmt::format("\"{}\" is no closing tag", shown(text_.substr(begin, at_ - begin + 1))),
           "closing tags are of the form </body>");
    return false;
  }
  ++at_;
  if (open_.empty()) {
    report(begin, fmt::format("</{}> closes nothing", shown(name)), "remove it, or open the element before");
    return false;
  }
  if (open_.back().name != name) {
    report(begin,
           fmt::format("</{}> stands where <{}> of line {} is still open", shown(name), shown(open_.back().name),
                       open_.back().line),
           fmt::format("close that with </{}>, or with \"/>\" in its own tag", shown(open_.back().name)));
    return false;
  }
  open_.pop_back();
  return true;
}

bool MarkupGuard::passOpeningTag() {
  const std::size_t begin = at_++;
  const std::string_view name = passName();
  if (name.empty()) {
    report(begin, "\"<\" begins no tag", "write \"&lt;\" for the character itself");
    return false;
  }
  if (open_.empty() && !std::exchange(root_, name).empty()) {
    report(begin, fmt::format("a second root element <{}> stands in the file", shown(name)), "one file holds one");
    return false;
  }
  std::set<std::string_view> attributes;
  for (;;) {
    const bool spaced = isSpace(here());
    passSpaces();
    if (at_ == text_.size() || here() == '<') {
      report(begin, fmt::format("the tag of <{}> is not closed", shown(name)), "close it with \">\" or \"/>\"");
      return false;
    }
    if (here() == '>') break;
    if (text_.substr(at_, 2) == "/>") {
      at_ += 2;
      return true;
    }
    const std::size_t attribute_begin = at_;
    const std::string_view attribute = passName();
    if (!attribute.empty() && !spaced) {
      report(attribute_begin, fmt::format("<{}>: no space stands before \"{}\"", shown(name), shown(attribute)),
             "put one there");
    }
    if (!attributes.insert(attribute).second) {
      report(attribute_begin, fmt::format("<{}>: attribute \"{}\" stands twice", shown(name), shown(attribute)),
             "remove one of them");
    }
    if (attributes.size() > kMostAttributes) {
      report(begin, fmt::format("<{}> has more than {} attributes", shown(name), kMostAttributes), "remove some");
      return false;
    }
    if (!passAttribute(name, attribute)) return false;
  }
  ++at_;
  open_.push_back({name, lineAt(begin)});
  if (open_.size() > kMostDepth) {
    report(begin, fmt::format("elements stand more than {} deep in each other", kMostDepth),
           "close some of them before");
    return false;
  }
  return true;
}

bool MarkupGuard::passAttribute(std::string_view element, std::string_view name) {
  const std::size_t begin = at_ - name.size();
  passSpaces();
  const bool equals = here() == '=';
  if (equals) ++at_;
  passSpaces();
  const char quote = here();
  if (name.empty() || !equals || (quote != '"' && quote != '\'')) {
    const std::string_view rest = text_.substr(begin, text_.find_first_of("\r\n>", begin) - begin);
    report(begin, fmt::format("<{}>: \"{}\" is no attribute", shown(element), shown(rest)),
           "attributes are of the form name=\"value\"");
    return false;
  }
  for (++at_; here() != quote;) {
    if (at_ == text_.size() || here() == '<') {
      report(begin, fmt::format("<{}>: the value of \"{}\" is not closed", shown(element), shown(name)),
             "close it with a quotation mark; \"<\" inside a value is written \"&lt;\"");
      return false;
    }
    passCharacter();
  }
  ++at_;
  return true;
}

}  // namespace vehicle
