#pragma once
// This turns a pose into bytes and back by the code that suturec writes. Users do not call that
// code: their calls and events do.

#include <capnp/common.h>

#include <array>
#include <cstddef>

#include "harness/pose.h"

namespace peers {

class GeneratedCodec {
 public:
  /// Does what `shm` and `frame` do. Returns the bytes of the slot.
  std::size_t throughSlot(const Pose& pose, Pose& back);
  /// Does what `rpc` does: a message of Cap'n Proto, and the slot at both ends. Returns the bytes
  /// of the message.
  std::size_t throughMessage(const Pose& pose, Pose& back);

 private:
  std::array<capnp::word, 128> scratch_{}, bytes_{};
};

}  // namespace peers
