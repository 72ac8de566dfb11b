#include "tests/architecture/pages.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vehicle::test {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFolders[] = {"apps/", "benchmarks/", "docs/", "libvehicle/", "models/", "tests/", "tools/"};

using EachLine = std::function<void(int number, const std::string& line, bool fenced)>;

void forEachLine(const fs::path& file, const EachLine& visit) {
  std::ifstream stream(file);
  int number = 0;
  bool fenced = false;
  for (std::string line; std::getline(stream, line);) {
    const bool fence = line.starts_with("```");
    if (fence) fenced = !fenced;
    visit(++number, line, fenced || fence);
  }
}

std::vector<fs::path> filesBelow(const fs::path& folder, const std::set<std::string>& endings) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && endings.contains(entry.path().extension().string())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> pagesOf(const fs::path& root) {
  std::vector<fs::path> pages{root / "README.md", root / "CHANGELOG.md"};
  for (const fs::path& page : filesBelow(root / "docs", {".md"})) pages.push_back(page);
  return pages;
}

std::string placeOf(const fs::path& root, const fs::path& file, int line) {
  return fs::relative(file, root).generic_string() + ":" + std::to_string(line) + ": ";
}

/// A heading as links name it: small letters, no punctuation, hyphens for blanks.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading.substr(heading.find_first_not_of("# "))) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0 || c == '_' || c == '-') anchor += static_cast<char>(std::tolower(letter));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

bool hasHeading(const fs::path& page, const std::string& anchor) {
  bool found = false;
  forEachLine(page, [&](int, const std::string& line, bool fenced) {
    const bool heading = line.starts_with('#') && line.find_first_not_of("# ") != std::string::npos;
    found |= !fenced && heading && anchorOf(line) == anchor;
  });
  return found;
}

struct Link {
  int line = 0;
  std::string file;    // "" for the page itself
  std::string anchor;  // "" for none
};

/// Links to files of the tree.
std::vector<Link> linksOf(const fs::path& page) {
  std::vector<Link> links;
  forEachLine(page, [&links](int number, const std::string& line, bool fenced) {
    if (fenced) return;
    for (std::size_t at = line.find("]("); at != std::string::npos; at = line.find("](", at + 1)) {
      const auto ticks = std::count(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(at), '`');
      const std::size_t end = line.find(')', at);
      if (ticks % 2 != 0 || end == std::string::npos) continue;
      const std::string target = line.substr(at + 2, end - at - 2);
      if (target.find("://") != std::string::npos) continue;
      const std::size_t hash = target.find('#');
      links.push_back({number, target.substr(0, hash), hash == std::string::npos ? "" : target.substr(hash + 1)});
    }
  });
  return links;
}

fs::path targetOf(const fs::path& page, const Link& link) {
  return link.file.empty() ? page : (page.parent_path() / link.file).lexically_normal();
}

/// Words of a line that might be paths, with the place where each begins.
std::vector<std::pair<std::size_t, std::string>> wordsOf(const std::string& line) {
  static constexpr std::string_view kMarks = "_-./*<>{},";
  const auto isOfPath = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || kMarks.find(c) != std::string_view::npos;
  };
  std::vector<std::pair<std::size_t, std::string>> words;
  for (std::size_t begin = 0; begin < line.size();) {
    std::size_t end = begin;
    while (end < line.size() && isOfPath(line[end])) ++end;
    std::string word = line.substr(begin, end - begin);
    while (!word.ends_with("...") && (word.ends_with('.') || word.ends_with(','))) word.pop_back();  // of the sentence
    if (!word.empty()) words.emplace_back(begin, word);
    begin = end + 1;
  }
  return words;
}

bool isPattern(const std::string& word) {
  return word.find_first_of("*<>{},") != std::string::npos || word.find("...") != std::string::npos;
}

bool beginsWithTopFolder(const std::string& word) {
  return std::any_of(std::begin(kFolders), std::end(kFolders),
                     [&](std::string_view folder) { return word.starts_with(folder); });
}

}  // namespace

Violations deadLinks(const fs::path& root) {
  Violations found;
  for (const fs::path& page : pagesOf(root)) {
    for (const Link& link : linksOf(page)) {
      const fs::path target = targetOf(page, link);
      const std::string place = placeOf(root, page, link.line);
      const std::string within = target.lexically_relative(root).generic_string();
      if (within.empty() || within.starts_with("..") || !fs::exists(target)) {
        found.push_back(place + "the link leads to " + link.file + ", which does not exist");
      } else if (!link.anchor.empty() && !hasHeading(target, link.anchor)) {
        found.push_back(place + "the link leads to #" + link.anchor + ", and " + within + " has no such heading");
      }
    }
  }
  return found;
}

Violations pathsToNothing(const fs::path& root) {
  const House house(root);
  Violations found;
  const auto check = [&](const fs::path& file, int number, const std::string& path) {
    if (fs::exists(root / path)) return;
    found.push_back(placeOf(root, file, number) + "names " + path + ", which does not exist");
  };
  for (const fs::path& page : pagesOf(root)) {
    forEachLine(page, [&](int number, const std::string& line, bool) {
      for (const auto& [begin, word] : wordsOf(line)) {
        if (isPattern(word)) continue;
        if (beginsWithTopFolder(word)) check(page, number, word);
        const std::size_t slash = word.find('/');
        const bool quoted = begin > 0 && line[begin - 1] == '`';
        if (quoted && slash != std::string::npos && house.rooms().contains(word.substr(0, slash))) {
          check(page, number, "libvehicle/" + word);
        }
      }
    });
  }
  for (const char* folder : {"libvehicle", "apps"}) {
    for (const fs::path& file : filesBelow(root / folder, {".h", ".cc", ".inc", ".txt"})) {
      forEachLine(file, [&](int number, const std::string& line, bool) {
        for (const auto& [begin, word] : wordsOf(line)) {
          if (!isPattern(word) && word.starts_with("docs/")) check(file, number, word);
        }
      });
    }
  }
  return found;
}

Violations lonelyPages(const fs::path& root) {
  std::set<fs::path> reached;
  std::vector<fs::path> ahead{root / "README.md"};
  while (!ahead.empty()) {
    const fs::path page = ahead.back();
    ahead.pop_back();
    if (!fs::exists(page) || !reached.insert(page).second || page.extension() != ".md") continue;
    for (const Link& link : linksOf(page)) ahead.push_back(targetOf(page, link));
  }
  Violations found;
  for (const fs::path& page : filesBelow(root / "docs", {".md"})) {
    if (!reached.contains(page)) found.push_back(placeOf(root, page, 1) + "no link leads here from README.md");
  }
  return found;
}

}  // namespace vehicle::test
