#include <iostream>
#include <memory>

#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "libvehicle/xml/schema.h"

namespace vehicle::cli {

Action addSchema(CLI::App& program) {
  struct Options {
    bool as_xsd = false;
    bool as_markdown = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("schema", "print what may stand in each kind of file");
  CLI::Option* xsd_flag =
      command->add_flag("--xsd", options->as_xsd, "as XML schema, for editors and xmllint   (default)");
  command->add_flag("--markdown", options->as_markdown, "as the page of the documentation")->excludes(xsd_flag);
  command->footer("Example: vehicle schema --xsd > vehicle.xsd");
  return [options] {
    std::cout << (options->as_markdown ? schemaMarkdown() : xsd());
    return static_cast<int>(kDone);
  };
}

}  // namespace vehicle::cli
