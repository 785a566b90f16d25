#pragma once
// The lane of own frames: one socket a session for all of its connections.

#include <suture/lane/frame/lane_thread.h>
#include <suture/lane/lane_kind.h>

namespace suture::frame {

/// Has the thread that carries the frames of this process.
class FrameLane final : public LaneKind {
 public:
  /// Throws SetupError if the kernel refuses what the thread needs.
  FrameLane() = default;

  const char* name() const override { return "frame"; }
  kj::Own<LaneClient> makeClient(ClientSession& session) override;
  kj::Own<LaneServer> makeServer(ServerSession& session) override;
  void stop() override { thread_.stop(); }

 private:
  LaneThread thread_;
};

}  // namespace suture::frame
