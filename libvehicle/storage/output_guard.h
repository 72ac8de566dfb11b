#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libvehicle/storage/file_identity.h"
#include "libvehicle/storage/output_kind.h"

namespace vehicle {

/// What may be replaced beside outputs of an earlier run and empty files.
enum class Overwrite {
  kOwnFiles,  // nothing: a file that this program has not written is refused
  kAnyFile,   // any file, but of a database only a study's; never an input
};

/// Decides, before a command works, what it may write. A command names every file that it reads by protect() and every
/// file that it is to write by claim(), in any order; refused is, with nothing touched,
///   - the same file (file_identity.h) as an input, as another output, or as a database or one of its companions;
///   - a name with another ending than those of its kind;
///   - a folder or device, and a file that this program has not written, unless overwriting was asked for;
///   - a place where no file can be written.
/// Every refusal is one line that names the option, its file and what stands in the way.
///
/// All throw std::invalid_argument for a refusal, RunFailed where the system does not let a file be written.
class OutputGuard {
 public:
  explicit OutputGuard(Overwrite overwrite = Overwrite::kOwnFiles) : overwrite_(overwrite) {}

  /// A file that the command reads.
  /// @param what  as messages call it: "the vehicle file"
  void protect(const std::filesystem::path& file, const std::string& what);
  /// A database that the command reads, with its companions.
  void protectDatabase(const std::filesystem::path& file, const std::string& what);

  /// A file that the command is to write.
  /// @param option  as the user has given it: "--output"
  void claim(const std::filesystem::path& file, const std::string& option, OutputKind kind);
  /// A new database of a study; of one that is there only a study that nobody writes, and only to be overwritten.
  void claimDatabase(const std::filesystem::path& file, const std::string& option);
  /// A study's database that is to be gone on with, or begun where there is none.
  void resumeDatabase(const std::filesystem::path& file, const std::string& option);
  /// Files of one kind in a folder, which is made where it is missing when they are written.
  /// @param names  all that may be written, within the folder
  void claimFolder(const std::filesystem::path& folder, const std::string& option, OutputKind kind,
                   const std::vector<std::string>& names);

 private:
  struct Entry {
    std::string path;       // as the user wrote it
    std::string option;     // of an output; "" of an input
    std::string what;       // of an input; "" of an output
    std::string companion;  // the database that it belongs to; "" where it is a file of its own
  };

  void add(const std::filesystem::path& file, const Entry& entry);
  void addCompanions(const std::filesystem::path& file, const Entry& database);
  void requireReplaceable(const std::filesystem::path& file, const std::string& option, OutputKind kind) const;

  Overwrite overwrite_;
  std::map<FileIdentity, Entry> entries_;
};

}  // namespace vehicle
