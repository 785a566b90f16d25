#pragma once
// Carries IP packets between the two ends of a link.

#include "experiment/link/link_end.h"
#include "experiment/link/packet_line.h"

namespace experiment {

/// Belongs to one thread, but for its counts. The ends must outlive it.
class Forwarder {
 public:
  /// Throws suture::SetupError if the kernel has no timer for it.
  Forwarder(const LinkEnd& here, const LinkEnd& there, const PacketFate& fate);
  ~Forwarder();
  Forwarder(const Forwarder&) = delete;
  Forwarder& operator=(const Forwarder&) = delete;

  /// Forwards until the descriptor `end` can be read, as that of a process can that has ended.
  void runUntil(int end);

  const PacketCounts& thereCounts() const { return there_.counts(); }  ///< from here to there
  const PacketCounts& backCounts() const { return back_.counts(); }

 private:
  void setTimer() const;

  PacketLine there_, back_;
  const int timer_;
};

}  // namespace experiment
