#include "libvehicle/storage/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

FileLock::FileLock(const std::filesystem::path& path) : lock_(path) {
  lock_ += "-lock";
  while (true) {
    descriptor_ = ::open(lock_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      throw RunFailed(fmt::format("{}: cannot be written: {}; its folder must exist and be writable", path.string(),
                                  std::generic_category().message(errno)));
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const int error = errno;
      ::close(descriptor_);
      if (error == EINTR) continue;
      if (error == EWOULDBLOCK) {
        throw RunFailed(fmt::format("{}: another process is writing it; wait for its end", path.string()));
      }
      ::unlink(lock_.c_str());  // nobody can hold it where there are no locks
      throw RunFailed(fmt::format("{}: cannot be locked: {}", path.string(), std::generic_category().message(error)));
    }
    // Whoever held the lock before may have removed the file after we opened it: then we hold nothing.
    struct stat held {};
    struct stat named {};
    if (::fstat(descriptor_, &held) == 0 && ::stat(lock_.c_str(), &named) == 0 && held.st_ino == named.st_ino &&
        held.st_dev == named.st_dev) {
      return;
    }
    ::close(descriptor_);
  }
}

FileLock::~FileLock() {
  ::unlink(lock_.c_str());
  ::close(descriptor_);
}

}  // namespace vehicle
