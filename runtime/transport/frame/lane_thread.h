#pragma once
// The one thread of a process that carries its frame connections.

#include <kj/io.h>
#include <suture/rt/doorbell.h>
#include <suture/transport/frame/connection.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace suture::frame {

/// Sleeps until a task rings or a socket has something, then takes and gives everything that can
/// be. In steady state it neither allocates nor locks; TLS does. A slow handshake or a slow peer on
/// another connection delays nobody here. All signals are blocked in it.
class LaneThread {
 public:
  /// The thread begins with the first connection. Throws SetupError if the kernel refuses.
  LaneThread();
  ~LaneThread() { stop(); }
  LaneThread(const LaneThread&) = delete;
  LaneThread& operator=(const LaneThread&) = delete;

  /// Any thread: carries it until it is over.
  void add(std::shared_ptr<Connection> connection);

  /// Whoever made it: lets go of all connections, and rings nobody any more.
  void stop();

  /// Any thread rings it when a channel has something, and may when this object is gone.
  std::shared_ptr<rt::Doorbell> doorbell() { return {bell_, &bell_->doorbell}; }

 private:
  struct Bell {
    kj::AutoCloseFd eventDescriptor;
    rt::Doorbell doorbell;
  };
  struct Carried {
    std::shared_ptr<Connection> connection;
    bool full = false;  // the poll waits for room in its socket
  };

  static std::shared_ptr<Bell> makeBell();
  void start();
  void loop();
  void takeOver();
  void watch(const Carried& carried, int operation);
  void turnAll();
  void letGo(const Carried& carried);
  void sleep();

  const std::shared_ptr<Bell> bell_ = makeBell();
  kj::AutoCloseFd poll_;
  std::atomic<bool> stopping_{false}, anyAdded_{false};
  std::mutex mutex_;  // connections are made rarely, and no control loop waits here
  std::vector<std::shared_ptr<Connection>> added_;
  std::vector<Carried> carried_;  // the thread's
  std::thread thread_;
};

}  // namespace suture::frame
