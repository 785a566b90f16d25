#pragma once
// One socket between two processes, and the connections that share it.

#include <suture/lane/frame/connection.h>
#include <suture/lane/frame/frame_socket.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace suture::frame {

/// Belongs to the lane thread, but for what is said to be any thread's. All that its connections
/// have to send leaves in one send, and arrives in one receipt; it breaks for all of them.
class Link {
 public:
  /// `epoch`: in every frame, the same at the other end.
  Link(rpc::ByteStream bytes, std::uint32_t epoch) : socket_(std::move(bytes), epoch) {}
  ~Link() { end(); }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// Any thread: the next turn() takes it along. Its number is no other's. The provider's side
  /// joins before the client's, and sends nothing before it has heard that one.
  void join(std::shared_ptr<Connection> connection);
  /// Any thread: it carries nothing any more.
  bool broken() const { return broken_.load(std::memory_order_acquire); }
  /// Breaks it if it has no connection, as behind the last one; false: it has one.
  bool endIfEmpty();

  int descriptor() const { return socket_.descriptor(); }
  /// The socket tells that something has arrived.
  void arrived() { socket_.arrived(); }
  /// Takes what has come from either side of each connection, and gives it to the other.
  void turn();
  /// More has arrived than one turn takes, or is to be sent than one sends: nobody tells that
  /// again.
  bool hasMore() const {
    return socket_.mayHaveMore() || (unsent_ && !socket_.isFull() && !socket_.broken());
  }
  /// The socket has not taken all, and tells when it takes more.
  bool isFull() const { return socket_.isFull(); }
  /// Ends the socket, so that the other end is told.
  void end() { socket_.cut(); }

 private:
  void takeJoined();
  void receive();
  bool take(const Header& header);
  bool send();
  void breakAll();
  Connection* find(std::uint32_t number) const;

  FrameSocket socket_;
  Surplus surplus_;
  std::vector<std::shared_ptr<Connection>> connections_;  // by number
  std::size_t first_ = 0;                                 // to send, in turns
  bool unsent_ = false;  // a connection has more than its turn took
  std::atomic<bool> broken_{false}, anyJoined_{false};
  std::mutex mutex_;  // connections join rarely, and no control loop waits here
  std::vector<std::shared_ptr<Connection>> joined_;
};

}  // namespace suture::frame
