#pragma once
// These are the contracts of the peer. The harness's own structs travel as they are.

#include <suture/annotate.h>

#include "harness/pose.h"

namespace peers {

SUTURE_EXTERNAL_TYPE(Pose, rotation, position, timestamp, valid, member(frame, capacity(8)),
                     member(reference, capacity(8)));
SUTURE_EXTERNAL_TYPE(Blob, timestamp, member(data, capacity(131072), bulk()));

class SUTURE_INTERFACE() Echo {
 public:
  virtual ~Echo() = default;

  /// The pose comes back as the event bounced.
  SUTURE_COMMAND() virtual void bounce(const Pose& pose) = 0;
  /// The pose comes back as the return value.
  SUTURE_COMMAND() virtual Pose ping(const Pose& pose) = 0;
  /// The pose goes one way.
  SUTURE_COMMAND(queue(2048)) virtual void push(const Pose& pose) = 0;

  SUTURE_EVENT() suture::EventOf<Pose> bounced;
};

/// It is an interface of its own, for its messages are large.
class SUTURE_INTERFACE() BlobEcho {
 public:
  virtual ~BlobEcho() = default;

  /// The blob comes back as the event bounced.
  SUTURE_COMMAND(queue(2)) virtual void bounce(const Blob& blob) = 0;

  SUTURE_EVENT(queue(2)) suture::EventOf<Blob> bounced;
};

/// This is published to everybody.
class SUTURE_INTERFACE() Feed {
 public:
  virtual ~Feed() = default;

  SUTURE_EVENT(queue(2048)) suture::EventOf<Pose> pose;
};

}  // namespace peers
