#pragma once

#include <string>
#include <vector>

#include "libvehicle/definition/suite.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/xml/file_source.h"
#include "libvehicle/xml/schema.h"

namespace vehicle {

/// The file that `naming_file` means by `named`: relative names count from the naming file's folder.
[[nodiscard]] std::string resolvePath(const std::string& naming_file, const std::string& named);

/// What is wrong with a file that another one names, at the place that names it: it cannot be read, or holds something
/// else than is expected there. What is wrong inside it, its own reader reports; a name that could not be read is
/// reported already.
/// @param holder  element that names it: "suite"
/// @param kinds   what the file may be, not empty; the element is called after the first
[[nodiscard]] ProblemList checkNamedFile(const std::string& holder, const FileReference& reference,
                                         const std::vector<FileKind>& kinds, FileSource& files);

}  // namespace vehicle
