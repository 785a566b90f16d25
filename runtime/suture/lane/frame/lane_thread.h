#pragma once
// This is the one thread of a process that carries its frame links.

#include <kj/io.h>
#include <suture/lane/frame/frame_link.h>
#include <suture/loop/event_bell.h>
#include <suture/rt/thread.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace suture::frame {

/// Sleeps until a task rings or a socket has something, then takes and gives everything that it
/// can. In steady state it neither allocates nor locks; TLS does. A slow handshake or a slow peer
/// on one link does not delay the others. All signals are blocked in it.
class LaneThread : private VirtualTime::Sockets {
 public:
  /// The thread begins with the first link. Throws SetupError if the kernel refuses.
  LaneThread();
  ~LaneThread() { stop(); }
  LaneThread(const LaneThread&) = delete;
  LaneThread& operator=(const LaneThread&) = delete;

  /// Any thread. Carries the link until it breaks, or is empty and no one else holds it.
  void add(std::shared_ptr<FrameLink> link);

  /// The thread that made it. Drops all links, and rings no thread any more.
  void stop();

  /// Any thread rings it when a channel has something, or a link another connection or owner, also
  /// after this object is gone.
  std::shared_ptr<rt::Doorbell> doorbell() { return bell_.sharedDoorbell(); }

 private:
  struct Carried {
    std::shared_ptr<FrameLink> link;
    bool full = false;  // the poll waits for room in its socket
  };

  void loop();
  void requireRing();
  void takeOver();
  void watch(const Carried& carried, int operation);
  void turnAll();
  bool isDone(const Carried& carried);
  void sleep();
  bool look() final;
  bool mayFind() final;
  int takeArrivals(int timeout);

  const loop::EventBell bell_{"start the thread of frames"};
  kj::AutoCloseFd poll_;
  std::atomic<bool> stopping_{false}, anyAdded_{false};
  std::mutex mutex_;  // no control loop waits for it, because links are made rarely
  std::vector<std::shared_ptr<FrameLink>> added_;
  std::vector<Carried> carried_;  // only the thread uses it
  rt::Thread thread_;
};

}  // namespace suture::frame
