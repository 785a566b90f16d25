#pragma once
// This notes the invalid part of the last value that was refused.

#include <suture/base/field_path.h>
#include <suture/rt/snapshot.h>

#include <atomic>

namespace suture {

/// Any thread notes and reads; neither waits nor allocates. Of two refusals at one moment, one is
/// kept.
class LastInvalid {
 public:
  void note(const FieldPath& path) {
    if (noting_.test_and_set(std::memory_order_acquire)) return;
    last_.write(path);
    noting_.clear(std::memory_order_release);
  }
  /// Returns the last one, or an empty path before the first.
  FieldPath read() const { return last_.read(); }

 private:
  std::atomic_flag noting_ = ATOMIC_FLAG_INIT;
  rt::Snapshot<FieldPath> last_;
};

}  // namespace suture
