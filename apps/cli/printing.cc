#include "apps/cli/printing.h"

#include <charconv>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

#include "libvehicle/report/document/warning_table.h"

namespace vehicle::cli {

std::size_t pageWidth() {
  if (const char* given = std::getenv("COLUMNS")) {
    const std::string_view text = given;
    std::size_t width = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), width);
    if (error == std::errc() && stop == text.data() + text.size() && width > 0) return width;
  }
  winsize size{};
  if (isatty(STDOUT_FILENO) == 1 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return report::kAnyWidth;
}

void printDocument(report::Document document, const Warnings& warnings, const CommonOptions& common) {
  if (common.format != report::Format::kTable) document.tables.push_back(report::warningTable(warnings));
  report::print(document, common.format, std::cout, pageWidth());
  std::cout.flush();  // what stderr says of it comes behind it
}

void printNote(const std::string& text, const CommonOptions& common) {
  if (!common.quiet) std::cerr << "note: " << text << '\n';
}

void printNotes(const std::vector<Note>& notes, const CommonOptions& common) {
  for (const Note& each : notes) printNote(each.line(), common);
}

void printWritten(const std::vector<std::string>& files, const CommonOptions& common) {
  for (const std::string& each : files) {
    if (!common.quiet) std::cerr << "written: " << each << '\n';
  }
}

void printWarnings(const Warnings& warnings) {
  for (const std::string& line : report::warningLines(warnings)) std::cerr << line << '\n';
}

ExitStatus statusAfter(const Warnings& warnings, const CommonOptions& common) {
  return common.strict && !warnings.empty() ? kCheckDidNotHold : kDone;
}

}  // namespace vehicle::cli
