#pragma once
// The one thread of a process that carries its frame links.

#include <kj/io.h>
#include <suture/lane/frame/link.h>
#include <suture/rt/doorbell.h>
#include <suture/rt/thread.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace suture::frame {

/// Sleeps until a task rings or a socket has something, then takes and gives everything that can
/// be. In steady state it neither allocates nor locks; TLS does. A slow handshake or a slow peer on
/// another link delays nobody here. All signals are blocked in it.
class LaneThread : private VirtualTime::Sockets {
 public:
  /// The thread begins with the first link. Throws SetupError if the kernel refuses.
  LaneThread();
  ~LaneThread() { stop(); }
  LaneThread(const LaneThread&) = delete;
  LaneThread& operator=(const LaneThread&) = delete;

  /// Any thread: carries it until it breaks, or is empty and nobody else holds it.
  void add(std::shared_ptr<Link> link);

  /// The thread that made it: lets go of all links, and rings nobody any more.
  void stop();

  /// Any thread rings it when a channel has something, or a link another connection or owner, and
  /// may when this object is gone.
  std::shared_ptr<rt::Doorbell> doorbell() { return {bell_, &bell_->doorbell}; }

 private:
  struct Bell {
    kj::AutoCloseFd eventDescriptor;
    rt::Doorbell doorbell;
  };
  struct Carried {
    std::shared_ptr<Link> link;
    bool full = false;  // the poll waits for room in its socket
  };

  static std::shared_ptr<Bell> makeBell();
  void loop();
  void takeOver();
  void watch(const Carried& carried, int operation);
  void turnAll();
  bool isDone(const Carried& carried);
  void sleep();
  bool look() final;
  bool mayFind() final;
  int takeArrivals(int timeout);

  const std::shared_ptr<Bell> bell_ = makeBell();
  kj::AutoCloseFd poll_;
  std::atomic<bool> stopping_{false}, anyAdded_{false};
  std::mutex mutex_;  // links are made rarely, and no control loop waits here
  std::vector<std::shared_ptr<Link>> added_;
  std::vector<Carried> carried_;  // the thread's
  rt::Thread thread_;
};

}  // namespace suture::frame
