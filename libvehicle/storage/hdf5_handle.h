#pragma once

#include <mutex>
#include <string>
#include <utility>

#include <hdf5.h>

namespace vehicle {

/// HDF5 said no; its innermost reason is the text. Never leaves this room: callers add the path.
struct Hdf5Error {
  std::string reason;
};

/// One caller's turn with HDF5, which keeps its state in globals: others wait, and its own printing of errors to
/// stderr is off until the turn ends.
class Hdf5Turn {
 public:
  Hdf5Turn();
  ~Hdf5Turn();
  Hdf5Turn(const Hdf5Turn&) = delete;
  Hdf5Turn& operator=(const Hdf5Turn&) = delete;

 private:
  std::lock_guard<std::mutex> lock_;
  H5E_auto2_t printer_ = nullptr;
  void* printer_data_ = nullptr;
};

/// The reason on top of HDF5's error stack, e.g. "file signature not found".
[[nodiscard]] std::string hdf5Reason();

/// @throws Hdf5Error if HDF5's answer (a status, a size, an identifier) is negative
template <class Answer>
Answer checked(Answer answer) {
  if (answer < 0) throw Hdf5Error{hdf5Reason()};
  return answer;
}

/// An HDF5 identifier with one owner.
class Hdf5Handle {
 public:
  using Closer = herr_t (*)(hid_t);
  /// @throws Hdf5Error if `id` is negative
  Hdf5Handle(hid_t id, Closer closer) : id_(checked(id)), closer_(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), closer_(other.closer_) {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  ~Hdf5Handle() {
    if (id_ >= 0) closer_(id_);
  }
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor): every HDF5 call takes one

 private:
  hid_t id_;
  Closer closer_;
};

}  // namespace vehicle
