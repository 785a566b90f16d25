#pragma once
// This is one socket between two processes, with the connections that share it.

#include <suture/lane/frame/connection.h>
#include <suture/lane/frame/frame_socket.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace suture::frame {

/// Belongs to the lane thread, except where a comment says any thread. One send takes all that its
/// connections have to send, one receipt brings it, and a link that breaks has broken for them all.
class FrameLink {
 public:
  /// `epoch` is in every frame, and the same at the other end. `share` counts what values take
  /// beyond their contracts; null: the peer was called.
  FrameLink(net::ByteStream bytes, std::uint32_t epoch,
            std::unique_ptr<framing::PeerBudget::Share> share = nullptr)
      : socket_(std::move(bytes), epoch), surplus_(std::move(share)) {}
  ~FrameLink() { end(); }
  FrameLink(const FrameLink&) = delete;
  FrameLink& operator=(const FrameLink&) = delete;

  /// Any thread. The next turn() carries the connection, whose number must be unique. The
  /// provider's side joins before the client's, and sends nothing before it has heard that one.
  void join(std::shared_ptr<Connection> connection);
  /// Any thread. Returns true if it carries nothing any more.
  bool broken() const { return broken_.load(std::memory_order_acquire); }
  /// Any thread, once broken(). Returns what this end refused of the peer, in words; "" if the link
  /// has just ended.
  const std::string& refusal() const { return socket_.refusal(); }
  /// Breaks it if it has no connection, as after the last one. Returns false if it has one.
  bool endIfEmpty();

  int descriptor() const { return socket_.descriptor(); }
  /// Call it when the socket says that something has arrived.
  void arrived() { socket_.arrived(); }
  /// Takes what has come from either side of each connection, and gives it to the other.
  void turn();
  /// Does so in one direction, before it looks at what has arrived; not while isFull(). Returns
  /// true if a connection has something to send.
  bool gives();
  /// Returns true if more has arrived than one turn takes, or must be sent than one sends, which
  /// the socket does not tell again.
  bool hasMore() const {
    return socket_.mayHaveMore() || (unsent_ && !socket_.isFull() && !socket_.broken());
  }
  /// Returns true if the socket has not taken all; it tells when it takes more.
  bool isFull() const { return socket_.isFull(); }
  /// Lets the next turn() break it; `why` says the reason in words.
  void breakOff(std::string why) { socket_.breakOff(std::move(why)); }
  /// Ends the socket, so that the other end notices.
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
  std::size_t first_ = 0;                                 // the first to send, by turns
  bool unsent_ = false;  // a connection has more than its turn took
  std::atomic<bool> broken_{false}, anyJoined_{false};
  std::mutex mutex_;  // no control loop waits for it, because connections join rarely
  std::vector<std::shared_ptr<Connection>> joined_;
};

}  // namespace suture::frame
