#include "apps/cli/stdout_page.h"

#include <charconv>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

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
  return kAnyWidth;
}

void printToStdout(const Document& document, Format format) { print(document, format, std::cout, pageWidth()); }

}  // namespace vehicle::cli
