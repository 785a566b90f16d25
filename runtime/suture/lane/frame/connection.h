#pragma once
// One connection over frames, as either process sees it.

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

/// Carries everything between a channel and its share of a link. Values of a peer are judged before
/// a component sees them. Belongs to the lane thread, but for what is said to be any thread's.
class Connection {
 public:
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  std::uint32_t number() const { return number_; }
  /// This uses them for as long as it is turned: they are its link's.
  void use(FrameSocket& socket, Surplus& surplus) {
    socket_ = &socket;
    surplus_ = &surplus;
  }
  /// Returns how much of the surplus this has taken.
  std::size_t surplus() const { return pieces_.surplus(); }
  /// A frame of this connection has arrived; false if there can be no such.
  bool arrived(const Header& header, std::span<std::byte> payload);
  /// Called behind all frames that have arrived: wakes those whom they are for.
  virtual void taken() {}
  /// Sends what the channel has, as far as there is room, but of a value that travels in pieces
  /// only one; true if it may have more.
  bool send();

  /// There is nothing to carry any more.
  bool over() const;
  /// The link carries nothing any more.
  void breakOff(const std::string& why);

  /// Any thread: the link carries nothing any more. Then the channel's watcher has been rung.
  bool broken() const { return broken_.load(std::memory_order_acquire); }
  /// Any thread, once broken(): why, in words.
  const std::string& why() const { return why_; }

 protected:
  /// `number`: on its link.
  Connection(std::shared_ptr<Channel> channel, std::unique_ptr<Payloads> payloads,
             std::uint32_t number);

  virtual bool take(const Header& header, std::span<std::byte> payload) = 0;
  /// So much has come of the payload of a frame of this kind, which take() gets whole.
  virtual void takePart(Kind, std::span<std::byte>) {}
  /// Sends what there is; true: it goes on at the next turn.
  virtual bool give() = 0;
  /// All of the payload that sendValue() got has been sent, in a frame of this kind.
  virtual void letGo(Kind kind) = 0;

  bool hasRoom() const { return rest_.empty() && mayGoOn(); }
  /// Only if hasRoom(). No payload is larger than kMostPayload.
  void sendFrame(Header header, std::span<const std::byte> payload = {});
  /// Only if hasRoom(): sends a payload of any size, at more than one turn if it is large. Until
  /// letGo() it stays valid.
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
  Pieces pieces_;                    // that have arrived
  Header whole_;                     // of the value that is being sent
  std::uint32_t wholeSize_ = 0;      // its bytes
  std::span<const std::byte> rest_;  // of them what has not been sent
  std::string why_;
  std::atomic<bool> broken_{false};
};

}  // namespace suture::frame
