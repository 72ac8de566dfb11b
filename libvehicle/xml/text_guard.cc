#include "libvehicle/xml/text_guard.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "libvehicle/xml/markup_guard.h"
#include "libvehicle/xml/message_text.h"

namespace vehicle {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

struct Fault {
  std::size_t offset;
  std::string message;
  std::string remedy;
};

// One such byte means another encoding or no text at all: the first tells it, the rest would be noise.
std::optional<Fault> faultOfBytes(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequenceLength(text.substr(i));
    const unsigned byte = static_cast<unsigned char>(text[i]);
    if (length == 0) return Fault{i, fmt::format("byte 0x{:02X} is no UTF-8", byte), "save the file as UTF-8"};
    if (length == 1 && !isXmlCharacter(byte)) {
      return Fault{i, fmt::format("the control character 0x{:02X} is no text", byte), "remove it"};
    }
    const std::string_view sequence = text.substr(i, length);
    if (sequence == "\xEF\xBF\xBE" || sequence == "\xEF\xBF\xBF") {
      return Fault{i, "the code points U+FFFE and U+FFFF are no characters", "remove them"};
    }
    i += length;
  }
  return std::nullopt;
}

/// Name of the encoding in `<?xml version="1.0" encoding="UTF-8"`; UTF-8 if none is told.
std::string encodingOf(std::string_view declaration) {
  const std::size_t key = declaration.find("encoding");
  if (key == std::string_view::npos) return "UTF-8";
  const std::size_t open = declaration.find_first_of("\"'", key);
  if (open == std::string_view::npos) return "";
  const std::size_t close = declaration.find(declaration[open], open + 1);
  return std::string(close == std::string_view::npos ? "" : declaration.substr(open + 1, close - open - 1));
}

bool isUtf8(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return name == "UTF-8" || name == "US-ASCII";
}

GuardedText single(std::string_view file_name, int line, std::string message, std::string remedy) {
  Problem problem;
  problem.place.file = file_name;
  problem.place.line = line;
  problem.message = std::move(message);
  problem.remedy = std::move(remedy);
  GuardedText guarded;
  guarded.problems.add(std::move(problem));
  return guarded;
}

}  // namespace

Problem tooMany(const Place& place) {
  Problem problem;
  problem.place = place;
  problem.message = fmt::format("there are more than {} problems", kMostProblems);
  problem.remedy = "correct these first; the others are printed then";
  return problem;
}

GuardedText guardText(std::string_view text, const std::string& file_name) {
  if (text.size() > kMostBytes) {
    return single(file_name, 0, fmt::format("the file is larger than {} KiB", kMostBytes / 1024),
                  "no vehicle, scenario or suite needs as much: is it the right file?");
  }
  if (const std::optional<Fault> fault = faultOfBytes(text)) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(fault->offset);
    return single(file_name, 1 + static_cast<int>(std::count(text.begin(), end, '\n')), fault->message, fault->remedy);
  }
  // <?xml version="1.0" encoding="UTF-8"?> at the very beginning, or nothing.
  std::size_t begin = text.substr(0, kByteOrderMark.size()) == kByteOrderMark ? kByteOrderMark.size() : 0;
  const std::size_t end = text.find("?>", begin);
  if (text.substr(begin, 6) == "<?xml " && end != std::string_view::npos) {
    const std::string encoding = encodingOf(text.substr(begin, end - begin));
    if (!isUtf8(encoding)) {
      return single(file_name, 1, fmt::format("encoding=\"{}\"; files are UTF-8", shown(encoding)),
                    "save the file as UTF-8 and write encoding=\"UTF-8\"");
    }
    begin = end + 2;
  }
  MarkupGuard guard(text, file_name);
  GuardedText guarded{"", guard.run(begin)};
  if (!guarded.problems.empty()) return guarded;
  guarded.text = text;
  for (const auto& [from, to] : guard.ignored()) {
    for (std::size_t i = from; i < to; ++i) {
      if (guarded.text[i] != '\n' && guarded.text[i] != '\r') guarded.text[i] = ' ';
    }
  }
  return guarded;
}

bool isXmlCharacter(std::uint32_t code) {
  return code == 0x9 || code == 0xA || code == 0xD || (code >= 0x20 && code <= 0xD7FF) ||
         (code >= 0xE000 && code <= 0xFFFD) || (code >= 0x10000 && code <= 0x10FFFF);
}

}  // namespace vehicle
