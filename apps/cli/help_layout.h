#pragma once

#include <string>

#include <CLI/App.hpp>

namespace vehicle::cli {

/// Help in the layout of style.md: usage, sentence, arguments, options with unit and default, example, exit status.
class HelpLayout : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace vehicle::cli
