#include "libvehicle/xml/named_file.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "libvehicle/xml/message_text.h"
#include "libvehicle/xml/reader.h"

namespace vehicle {

std::string resolvePath(const std::string& naming_file, const std::string& named) {
  return (std::filesystem::path(naming_file).parent_path() / named).lexically_normal().string();
}

ProblemList checkNamedFile(const std::string& holder, const FileReference& reference,
                           const std::vector<FileKind>& kinds, FileSource& files) {
  ProblemList problems;
  if (!reference.origin.knows("file")) return problems;
  const std::string& element = schemaOf(kinds.front()).name;
  const std::string path = fmt::format("<{}><{}>", holder, element);
  const std::string written = fmt::format("file=\"{}\"", shown(reference.file));
  const Outcome<FileKind> found = kindOf(resolvePath(reference.origin.file, reference.file), files);
  if (!found.value) {
    const Problem& first = found.problems[0];
    problems.add(reference.origin, path, fmt::format("{}: {}", written, first.message), first.remedy);
  } else if (std::find(kinds.begin(), kinds.end(), *found.value) == kinds.end()) {
    problems.add(reference.origin, path, fmt::format("{} holds a <{}>", written, schemaOf(*found.value).name),
                 fmt::format("a <{}> is expected here", element));
  }
  return problems;
}

}  // namespace vehicle
