#pragma once
// This is a lane that the runtime does not have: frames through a pair of pipes between two
// processes of one machine. It shows what a lane has to bring. Values travel encoded, as between
// builds that differ.

#include <suture/lane/frame/framed_connection.h>
#include <suture/lane/frame/lane_thread.h>
#include <suture/lane/lane_kind.h>
#include <suture/rt/thread.h>

#include <list>
#include <memory>

namespace conformance {

/// Belongs to the control thread.
class PipeLane final : public suture::LaneKind {
 public:
  ~PipeLane() noexcept(false) override { stop(); }

  const char* name() const override { return "pipe"; }
  kj::Own<suture::LaneClient> makeClient(suture::ClientSession& session) override;
  kj::Own<suture::LaneServer> makeServer(suture::ServerSession& session) override;
  void stop() override;

  /// Makes a link for one connection alone, which reads from one pipe and writes into the other.
  suture::frame::FramedOn lead(kj::AutoCloseFd in, kj::AutoCloseFd out);

 private:
  void pump(kj::AutoCloseFd from, kj::AutoCloseFd to);

  suture::frame::LaneThread thread_;
  std::list<suture::rt::Thread> pumps_;  // each ends with its link
};

}  // namespace conformance
