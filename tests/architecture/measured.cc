#include "tests/architecture/measured.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/architecture/results.h"

namespace vehicle::test {

namespace fs = std::filesystem;

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
  return text;
}

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Length of the number at the head of a text: "8 017", "0.27", "57".
std::size_t numberLength(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size() && isDigit(text[length])) ++length;
  const auto group = [&](std::size_t at) {
    const auto digit = [&](std::size_t i) { return i < text.size() && isDigit(text[i]); };
    return at < text.size() && text[at] == ' ' && digit(at + 1) && digit(at + 2) && digit(at + 3) && !digit(at + 4);
  };
  while (length > 0 && length <= 3 + 4 * 6 && group(length)) length += 4;
  if (length > 0 && length + 1 < text.size() && text[length] == '.' && isDigit(text[length + 1])) {
    ++length;
    while (length < text.size() && isDigit(text[length])) ++length;
  }
  return length;
}

/// A page with every run of white space as one blank, and where each letter stood.
struct Flattened {
  std::string text;
  std::vector<std::size_t> offset;  // in the file
};

Flattened flattened(const std::string& content) {
  Flattened flat;
  for (std::size_t i = 0; i < content.size(); ++i) {
    const bool blank = std::isspace(static_cast<unsigned char>(content[i])) != 0;
    if (blank && !flat.text.empty() && flat.text.back() == ' ') continue;
    flat.text += blank ? ' ' : content[i];
    flat.offset.push_back(i);
  }
  return flat;
}

/// Words of a page with expressions in place of its numbers.
struct Template {
  int line = 0;
  std::vector<std::string> words;  // one more than expressions
  std::vector<std::string> expressions;
};

Template templateOf(std::string_view text, int line) {
  Template made;
  made.line = line;
  for (bool more = true; more;) {
    const std::size_t open = text.find('{');
    more = open != std::string_view::npos;
    made.words.push_back(flattened(std::string(text.substr(0, open))).text);
    if (!more) break;
    const std::size_t close = text.find('}', open);
    made.expressions.emplace_back(text.substr(open + 1, close - open - 1));
    text.remove_prefix(close + 1);
  }
  return made;
}

struct Found {
  std::size_t begin = 0, end = 0;                            // of the whole, in the flattened text
  std::vector<std::pair<std::size_t, std::size_t>> numbers;  // place and length
};

std::optional<Found> matchAt(const Template& wanted, const std::string& text, std::size_t at) {
  Found found;
  found.begin = at;
  for (std::size_t i = 0; i < wanted.words.size(); ++i) {
    if (text.compare(at, wanted.words[i].size(), wanted.words[i]) != 0) return std::nullopt;
    at += wanted.words[i].size();
    if (i == wanted.expressions.size()) break;
    const std::size_t length = numberLength(std::string_view(text).substr(at));
    if (length == 0) return std::nullopt;
    found.numbers.emplace_back(at, length);
    at += length;
  }
  found.end = at;
  return found;
}

std::optional<Found> find(const Template& wanted, const std::string& text) {
  for (std::size_t at = text.find(wanted.words[0]); at != std::string::npos; at = text.find(wanted.words[0], at + 1)) {
    if (std::optional<Found> found = matchAt(wanted, text, at)) return found;
  }
  return std::nullopt;
}

/// What the file of printed numbers says of one page.
struct PageNumbers {
  std::string page;
  std::vector<Template> templates;
  std::vector<std::string> covered;  // headings: all rows of the tables below them are measured
};

struct PrintedNumbers {
  std::vector<std::string> machines;
  std::vector<PageNumbers> pages;
};

constexpr const char* kPrintedNumbers = "benchmarks/results/printed_numbers.txt";

PrintedNumbers readPrintedNumbers(const fs::path& root) {
  PrintedNumbers numbers;
  std::ifstream stream(root / kPrintedNumbers);
  int line = 0;
  for (std::string text; std::getline(stream, text);) {
    ++line;
    const std::string_view words = trimmed(text);
    if (words.empty() || words.front() == '#') continue;
    if (text.front() != ' ') {
      const std::size_t blank = words.find(' ');
      if (words.substr(0, blank) == "machine") {
        numbers.machines.emplace_back(words.substr(blank + 1));
      } else {
        numbers.pages.push_back({std::string(words), {}, {}});
      }
    } else if (words.starts_with("covers ")) {
      numbers.pages.back().covered.emplace_back(words.substr(7));
    } else {
      numbers.pages.back().templates.push_back(templateOf(words, line));
    }
  }
  return numbers;
}

/// One page held against the results.
class PageJudge {
 public:
  PageJudge(const fs::path& root, const PageNumbers& page, const Results& results)
      : file_(root / page.page),
        page_(page),
        results_(results),
        content_(contentOf(file_)),
        flat_(flattened(content_)) {}

  Violations judge() {
    for (const Template& each : page_.templates) judge(each);
    for (const std::string& heading : page_.covered) judgeCovered(heading);
    return std::move(found_);
  }

  void correct() const {
    std::string content = content_;
    for (auto each = corrections_.rbegin(); each != corrections_.rend(); ++each) {
      content.replace(each->first, each->second.first, each->second.second);
    }
    if (content != content_) std::ofstream(file_) << content;
  }

 private:
  [[nodiscard]] int lineOf(std::size_t offset) const {
    return 1 +
           static_cast<int>(std::count(content_.begin(), content_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
  }
  void report(const std::string& place, const std::string& what) { found_.push_back(place + ": " + what); }

  void judge(const Template& wanted) {
    const std::string origin = std::string(kPrintedNumbers) + ":" + std::to_string(wanted.line);
    const std::optional<Found> found = find(wanted, flat_.text);
    if (!found) return report(origin, page_.page + " has no such words");
    matched_.emplace_back(flat_.offset[found->begin], flat_.offset[found->end - 1]);
    for (std::size_t i = 0; i < wanted.expressions.size(); ++i) {
      const auto [at, length] = found->numbers[i];
      const std::string text = flat_.text.substr(at, length);
      const PrintedNumber printed = printedNumber(text);
      try {
        const double value = valueOf(wanted.expressions[i], results_);
        // Rounding of the last digit, and of the sums that made it.
        if (std::abs(value - printed.value) <= printed.half_unit * (1.0 + 1e-9)) continue;
        const std::string is = printedLike(text, value);
        report(page_.page + ":" + std::to_string(lineOf(flat_.offset[at])),
               "prints " + text + ", " + wanted.expressions[i] + " is " + is);
        corrections_[flat_.offset[at]] = {flat_.offset[at + length - 1] + 1 - flat_.offset[at], is};
      } catch (const std::invalid_argument& wrong) {
        report(origin, wrong.what());
      }
    }
  }

  /// Every row of the tables between a heading and the next one of its level.
  void judgeCovered(const std::string& heading) {
    std::istringstream lines(content_);
    std::size_t offset = 0;
    bool inside = false, was_there = false, in_body = false;
    const std::string level = heading.substr(0, heading.find(' ') + 1);
    for (std::string line; std::getline(lines, line); offset += line.size() + 1) {
      if (line == heading) {
        inside = was_there = true;
      } else if (line.starts_with(level)) {
        inside = false;
      }
      const bool row = line.starts_with('|');
      if (row && inside && in_body && !isMatched(offset)) {
        report(page_.page + ":" + std::to_string(lineOf(offset)),
               std::string("this row has no source in ") + kPrintedNumbers);
      }
      in_body = row && (in_body || line.starts_with("|-"));
    }
    if (!was_there) report(kPrintedNumbers, page_.page + " has no heading " + heading);
  }
  [[nodiscard]] bool isMatched(std::size_t offset) const {
    return std::any_of(matched_.begin(), matched_.end(),
                       [&](const auto& each) { return each.first <= offset && offset <= each.second; });
  }

  fs::path file_;
  const PageNumbers& page_;
  const Results& results_;
  std::string content_;
  Flattened flat_;
  Violations found_;
  std::vector<std::pair<std::size_t, std::size_t>> matched_;                // first and last letter, in the file
  std::map<std::size_t, std::pair<std::size_t, std::string>> corrections_;  // place: length, text instead
};

}  // namespace

PrintedNumber printedNumber(std::string_view text) {
  std::string plain;
  std::copy_if(text.begin(), text.end(), std::back_inserter(plain), [](char c) { return c != ' '; });
  const std::size_t point = plain.find('.');
  if (point != std::string::npos) {
    return {std::stod(plain), 0.5 * std::pow(10.0, -static_cast<double>(plain.size() - point - 1))};
  }
  std::size_t zeros = 0;
  while (plain.size() - zeros > 3 && plain[plain.size() - zeros - 1] == '0') ++zeros;
  return {std::stod(plain), 0.5 * std::pow(10.0, static_cast<double>(zeros))};
}

std::string printedLike(std::string_view like, double value) {
  const std::size_t first = like.find_first_of("123456789");
  const auto counts = [&](char c) { return isDigit(c); };
  auto digits =
      static_cast<int>(first == std::string_view::npos
                           ? 0
                           : std::count_if(like.begin() + static_cast<std::ptrdiff_t>(first), like.end(), counts));
  if (like.find('.') == std::string_view::npos) {
    for (auto last = like.rbegin(); digits > 3 && *last == '0'; ++last) --digits;
  }
  digits = std::max(digits, 2);
  const double size = value == 0.0 ? 1.0 : std::abs(value);
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(size)));
  const double unit = std::pow(10.0, -decimals);
  std::string text(64, '\0');
  text.resize(static_cast<std::size_t>(
      std::snprintf(text.data(), text.size(), "%.*f", std::max(decimals, 0), std::round(value / unit) * unit)));
  for (std::size_t at = text.find('.') == std::string::npos ? text.size() : text.find('.'); at > 3;) {
    at -= 3;
    text.insert(text.begin() + static_cast<std::ptrdiff_t>(at), ' ');
  }
  return text;
}

Violations wrongNumbers(const fs::path& root, Pages pages) {
  const PrintedNumbers numbers = readPrintedNumbers(root);
  std::vector<fs::path> folders;
  for (const std::string& each : numbers.machines) folders.push_back(root / "benchmarks/results" / each);
  const Results results(folders);
  Violations found;
  for (const PageNumbers& page : numbers.pages) {
    PageJudge judge(root, page, results);
    for (std::string& each : judge.judge()) found.push_back(std::move(each));
    if (pages == Pages::kCorrect) judge.correct();
  }
  return found;
}

}  // namespace vehicle::test
