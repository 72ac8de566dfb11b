#include "apps/cli/request.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>

namespace vehicle::cli {
namespace {

using Words = std::vector<std::string>;

bool isOption(const std::string& word) { return word.size() > 1 && word.front() == '-'; }

bool isOneOf(const std::string& word, const Words& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// What every command takes, before which command it may stand.
bool isCommon(const std::string& word) {
  return word == "-q" || word == "--quiet" || word == "--strict" || word == "--format" || word.starts_with("--format=");
}

/// How many words before the command are options that every command takes, with their values.
std::size_t optionsBefore(const Words& words) {
  std::size_t count = 0;
  while (count < words.size() && isOption(words[count]) && words[count] != "--") {
    count += words[count] == "--format" ? 2 : 1;
  }
  return std::min(count, words.size());
}

/// The first word that asks for a page instead of work; words.end() where none does. What follows "--" are files.
Words::const_iterator pageAsked(const Words& words) {
  const auto end = std::find(words.begin(), words.end(), "--");
  const auto found = std::find_if(words.begin(), end, [](const std::string& word) {
    return word == "-h" || word == "--help" || word == "--version";
  });
  return found == end ? words.end() : found;
}

/// Whether the one word after a command, options aside, is `help`.
bool isHelpOfCommand(const Words& words, std::size_t command) {
  const auto first = words.begin() + static_cast<std::ptrdiff_t>(command) + 1;
  const auto named = std::find_if_not(first, words.end(), isOption);
  return named != words.end() && *named == "help" &&
         std::find_if_not(named + 1, words.end(), isOption) == words.end() && !std::filesystem::exists("help");
}

}  // namespace

Request requestOf(const Words& words, const Words& commands) {
  const auto asked = pageAsked(words);
  if (asked != words.end() && *asked == "--version") return {.kind = Request::Kind::kVersion};
  const std::size_t place = optionsBefore(words);
  const bool is_named = place < words.size();
  if (is_named && words[place] == "help") {
    const auto topic = std::find_if_not(words.begin() + static_cast<std::ptrdiff_t>(place) + 1, words.end(), isOption);
    if (topic == words.end() || *topic == "help") return {.kind = Request::Kind::kHelp};
    if (isOneOf(*topic, commands)) return {.kind = Request::Kind::kHelp, .command = *topic};
    return {.words = {*topic}};  // unknown, as any other command
  }
  const bool is_known = is_named && isOneOf(words[place], commands);
  if (is_known && (asked != words.end() || isHelpOfCommand(words, place))) {
    return {.kind = Request::Kind::kHelp, .command = words[place]};
  }
  if (asked != words.end() && !is_named) return {.kind = Request::Kind::kHelp};
  if (is_named && !is_known) return {.words = {words[place]}};
  if (!is_known) {
    const auto unknown = std::find_if_not(words.begin(), words.end(), isCommon);
    return {.words = unknown == words.end() || (unknown != words.begin() && *(unknown - 1) == "--format")
                         ? Words{}
                         : Words{*unknown}};
  }
  Request request{.words = {words[place]}};
  const auto before = words.begin() + static_cast<std::ptrdiff_t>(place);
  request.words.insert(request.words.end(), words.begin(), before);
  request.words.insert(request.words.end(), before + 1, words.end());
  return request;
}

}  // namespace vehicle::cli
