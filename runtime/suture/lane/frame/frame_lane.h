#pragma once
// This is the lane of Suture's own frames: one socket of a session for all of its connections.

#include <suture/lane/frame/framed_connection.h>
#include <suture/lane/frame/lane_thread.h>
#include <suture/lane/lane_kind.h>

#include <string>

namespace suture::frame {

/// Owns the thread that carries the frames of this process.
class FrameLane final : public LaneKind {
 public:
  /// Throws SetupError if the kernel refuses what the thread needs. With Form::Encoded, values
  /// travel encoded between equal builds too, to measure what different builds cost.
  explicit FrameLane(const char* name = "frame", Form form = Form::Slots)
      : name_(name), form_(form) {}

  const char* name() const override { return name_; }
  std::string whyNever(const InterfaceInfo& contract, bool byUnixSocket) const override;
  Form form() const { return form_; }
  LaneThread& thread() { return thread_; }
  kj::Own<LaneClient> makeClient(ClientSession& session) override;
  kj::Own<LaneServer> makeServer(ServerSession& session) override;
  void stop() override { thread_.stop(); }

 private:
  const char* const name_;
  const Form form_;
  LaneThread thread_;
};

}  // namespace suture::frame
