#include "libvehicle/xml/text_guard.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/xml/message_text.h"

namespace vehicle {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// The characters of XML 1.0, section 2.2.
bool isXmlCharacter(std::uint32_t code) {
  return code == 0x9 || code == 0xA || code == 0xD || (code >= 0x20 && code <= 0xD7FF) ||
         (code >= 0xE000 && code <= 0xFFFD) || (code >= 0x10000 && code <= 0x10FFFF);
}

/// "&amp;" -> true, "&#215;" -> true, "&chassis;" -> false.
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

/// Walks once through the text, from markup to markup.
class Guard {
 public:
  Guard(std::string_view text, const std::string& file_name) : text_(text), file_(file_name) {}

  ProblemList run() {
    if (text_.substr(0, kByteOrderMark.size()) == kByteOrderMark) at_ = kByteOrderMark.size();
    if (!checkBytes()) return std::move(problems_);
    checkDeclaration();
    bool goes_on = true;
    while (goes_on && at_ < text_.size() && problems_.size() < kMostProblems) {
      if (text_[at_] == '<') {
        goes_on = passMarkup();
      } else {
        passCharacter();
      }
    }
    return std::move(problems_);
  }

 private:
  void report(std::size_t offset, std::string message, std::string remedy) {
    // Offsets grow but for the beginning of a tag, so lines are counted on from the last problem.
    if (offset < counted_) {
      counted_ = 0;
      line_ = 1;
    }
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
    counted_ = offset;
    problems_.add({{file_, line_}, "", std::move(message), std::move(remedy)});
  }

  // One such byte means another encoding or no text at all: the first tells it, the rest would be noise.
  bool checkBytes() {
    for (std::size_t i = at_; i < text_.size();) {
      const std::size_t length = sequenceLength(text_.substr(i));
      const unsigned byte = static_cast<unsigned char>(text_[i]);
      if (length == 0) {
        report(i, fmt::format("byte 0x{:02X} is no UTF-8", byte), "save the file as UTF-8");
        return false;
      }
      if (length == 1 && !isXmlCharacter(byte)) {
        report(i, fmt::format("the control character 0x{:02X} is no text", byte), "remove it");
        return false;
      }
      if (text_.substr(i, 3) == "\xEF\xBF\xBE" || text_.substr(i, 3) == "\xEF\xBF\xBF") {
        report(i, "the code point U+FFFE or U+FFFF is no character", "remove it");
        return false;
      }
      i += length;
    }
    return true;
  }

  // <?xml version="1.0" encoding="UTF-8"?> at the very beginning, or nothing.
  void checkDeclaration() {
    if (text_.substr(at_, 5) != "<?xml" || text_.substr(at_ + 5, 1).find_first_of(" \t\r\n?") != 0) return;
    const std::size_t end = text_.find("?>", at_);
    if (end == std::string_view::npos) return;  // told as a processing instruction
    const std::string_view declaration = text_.substr(at_, end - at_);
    const std::size_t encoding = declaration.find("encoding");
    if (encoding != std::string_view::npos) {
      const std::size_t open = declaration.find_first_of("\"'", encoding);
      const std::size_t close =
          open == std::string_view::npos ? open : declaration.find(declaration[open], open + 1);
      std::string name(close == std::string_view::npos ? "" : declaration.substr(open + 1, close - open - 1));
      std::string upper = name;
      std::transform(upper.begin(), upper.end(), upper.begin(),
                     [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
      if (upper != "UTF-8" && upper != "US-ASCII") {
        report(at_, fmt::format("encoding=\"{}\"; files are UTF-8", shown(name)),
               "save the file as UTF-8 and write encoding=\"UTF-8\"");
      }
    }
    at_ = end + 2;
  }

  void passCharacter() {
    if (text_[at_] != '&') {
      ++at_;
      return;
    }
    // Longer names than this are no reference that is allowed.
    const std::string_view rest = text_.substr(at_ + 1, 40);
    const std::size_t end = rest.find_first_of("; \t\r\n<>\"'&=");
    if (end == std::string_view::npos || rest[end] != ';' || end == 0) {
      report(at_, "\"&\" stands alone", "write \"&amp;\"");
    } else if (!isAllowedReference(rest.substr(0, end))) {
      report(at_, fmt::format("the entity \"&{};\" is not allowed", rest.substr(0, end)), "write what it stands for");
    }
    ++at_;
  }

  /// False where the rest of the file cannot be understood.
  bool passMarkup() {
    const std::string_view rest = text_.substr(at_);
    if (rest.substr(0, 4) == "<!--") return passComment();
    if (rest.substr(0, 9) == "<![CDATA[") return passUntil("]]>", 9, "<![CDATA[");
    if (rest.substr(0, 2) == "<!") {
      report(at_, "document types and entity declarations (\"<!\") are not allowed",
             "remove it; the program knows its files without");
      return false;
    }
    if (rest.substr(0, 2) == "<?") {
      report(at_, "processing instructions (\"<?\") are not allowed here",
             "only <?xml version=\"1.0\" encoding=\"UTF-8\"?> may stand, at the very beginning");
      return passUntil("?>", 2, "<?");
    }
    return passTag();
  }

  bool passUntil(std::string_view close, std::size_t opening, std::string_view name) {
    const std::size_t end = text_.find(close, at_ + opening);
    if (end == std::string_view::npos) {
      report(at_, fmt::format("\"{}\" is not closed", name), fmt::format("close it with \"{}\"", close));
      return false;
    }
    at_ = end + close.size();
    return true;
  }

  bool passComment() {
    const std::size_t begin = at_;
    if (!passUntil("-->", 4, "<!--")) return false;
    const std::string_view inside = text_.substr(begin + 4, at_ - 3 - (begin + 4));
    if (inside.find("--") != std::string_view::npos || (!inside.empty() && inside.back() == '-')) {
      report(begin, "\"--\" stands inside a comment", "XML ends comments there; write \"-\"");
    }
    return true;
  }

  bool passTag() {
    const std::size_t begin = at_++;
    while (at_ < text_.size() && text_[at_] != '>') {
      const char here = text_[at_];
      if (here == '<') return unclosedTag(begin);
      if (here != '"' && here != '\'') {
        ++at_;
        continue;
      }
      for (++at_; at_ < text_.size() && text_[at_] != here;) {
        if (text_[at_] == '<') {
          report(at_, "\"<\" stands in a value, or a quotation mark is missing before it", "write \"&lt;\", or close the value");
          return false;
        }
        passCharacter();
      }
      if (at_ < text_.size()) ++at_;
    }
    if (at_ == text_.size()) return unclosedTag(begin);
    ++at_;
    return true;
  }

  bool unclosedTag(std::size_t begin) {
    report(begin, fmt::format("the tag \"{}\" is not closed", shown(text_.substr(begin, at_ - begin))),
           "close it with \">\" or \"/>\"");
    return false;
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;       // next byte to look at
  std::size_t counted_ = 0;  // bytes whose lines are in line_
  int line_ = 1;
  ProblemList problems_;
};

}  // namespace

ProblemList guardText(std::string_view text, const std::string& file_name) {
  if (text.size() > kMostBytes) {
    ProblemList problems;
    Problem problem;
    problem.place.file = file_name;
    problem.message = fmt::format("the file is larger than {} KiB", kMostBytes / 1024);
    problem.remedy = "no vehicle, scenario or suite needs as much: is it the right file?";
    problems.add(problem);
    return problems;
  }
  return Guard(text, file_name).run();
}

}  // namespace vehicle
