#pragma once
// This is one connection over frames, as either process sees it.

#include <suture/component/channel/channel.h>
#include <suture/lane/frame/bytes/pieces.h>
#include <suture/lane/frame/frame_socket.h>
#include <suture/lane/frame/payloads/payloads.h>
#include <suture/lane/frame/window.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace suture::frame {

/// Belongs to the lane thread, except where a comment says any thread. Carries everything between a
/// channel and its share of a link. Checks values of a peer before a component sees them.
class Connection {
 public:
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  std::uint32_t number() const { return number_; }
  /// Gives it the socket and surplus of its link, which it uses at each turn.
  void use(FrameSocket& socket, Surplus& surplus) {
    socket_ = &socket;
    surplus_ = &surplus;
  }
  /// Returns how much of the surplus this has taken.
  std::size_t surplus() const { return pieces_.surplus(); }
  /// Takes a frame of this connection. Returns false if it cannot be right.
  bool arrived(const Header& header, std::span<std::byte> payload);
  /// Called after all frames that have arrived: wakes the threads that they are for.
  virtual void taken() {}
  /// Sends what the channel has, as far as there is room, but only one piece of a value that
  /// travels in pieces. Returns true if it may have more.
  bool send();

  /// Returns true if there is nothing to carry any more.
  bool over() const;
  /// Call it when the link carries nothing any more. `refusal` says what of the peer this end has
  /// refused; "": nothing.
  void breakOff(const std::string& why, const std::string& refusal = {});

  /// Any thread. Returns true if the link carries nothing any more; the channel's watcher has been
  /// rung then.
  bool broken() const { return broken_.load(std::memory_order_acquire); }
  /// Any thread, once broken(). Returns why, in words.
  const std::string& why() const { return why_; }
  /// Likewise; returns what this end refused.
  const std::string& refusal() const { return refusal_; }

 protected:
  /// `number` is its number on its link.
  Connection(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
             std::uint32_t number);

  virtual bool take(const Header& header, std::span<std::byte> payload) = 0;
  /// Takes the part that has come of the payload of a frame of this kind; take() gets the whole
  /// one.
  virtual void takePart(Kind, std::span<std::byte>) {}
  /// Sends what there is. Returns true if it goes on at the next turn.
  virtual bool give() = 0;
  /// Called when the whole payload that sendValue() got has been sent, in a frame of this kind.
  virtual void letGo(Kind kind) = 0;

  /// Returns true if the other end takes a payload of that size, which it bounds as this end does.
  bool fits(std::span<const std::byte> payload) const {
    return payload.size() <= payloads_->limit();
  }
  bool hasRoom() const { return rest_.empty() && mayGoOn(); }
  /// Call it only if hasRoom(). No payload may be larger than kMostPayload.
  void sendFrame(Header header, std::span<const std::byte> payload = {});
  /// Call it only if hasRoom(). Sends a payload of any size, at more than one turn if it is large.
  /// The payload must stay valid until letGo().
  void sendValue(const Header& header, std::span<const std::byte> payload);

  const std::shared_ptr<Channel> channel_;
  const std::unique_ptr<Payloads> payloads_;

 private:
  bool mayGoOn() const { return window_.isOpen() && socket_->hasRoom(); }
  void sendPiece();

  const std::uint32_t number_;
  FrameSocket* socket_ = nullptr;
  Surplus* surplus_ = nullptr;
  Window window_;
  Pieces pieces_;                    // those that have arrived
  Header whole_;                     // the header of the value that is being sent
  std::uint32_t wholeSize_ = 0;      // its bytes
  std::span<const std::byte> rest_;  // the bytes that have not been sent
  std::string why_, refusal_;
  std::atomic<bool> broken_{false};
};

}  // namespace suture::frame
