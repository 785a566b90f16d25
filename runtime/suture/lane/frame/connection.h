#pragma once
// One connection over frames, as either process sees it.

#include <suture/component/channel/channel.h>
#include <suture/lane/frame/frame_socket.h>
#include <suture/lane/frame/window.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace suture::frame {

/// The bytes of the largest payload: slots travel as they lie in memory, between processes of one
/// memoryLayout(). Values of a peer are judged before a component sees them.
std::size_t mostPayload(const InterfaceInfo& contract);

/// Carries everything between a channel and its share of a link. Belongs to the lane thread, but
/// for what is said to be any thread's.
class Connection {
 public:
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  std::uint32_t number() const { return number_; }
  std::size_t mostPayload() const { return frame::mostPayload(channel_->info); }

  /// The socket of the link, for as long as this is turned.
  void use(FrameSocket& socket) { socket_ = &socket; }
  /// A frame of this connection has arrived; false if there can be no such.
  bool arrived(const Header& header, std::span<std::byte> payload);
  /// Called behind all frames that have arrived: wakes those whom they are for.
  virtual void taken() {}
  /// Sends what the channel has, as far as there is room; true if it may have more, which the
  /// socket had no room for.
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
  Connection(std::shared_ptr<Channel> channel, std::uint32_t number);

  virtual bool take(const Header& header, std::span<std::byte> payload) = 0;
  virtual void give() = 0;

  /// A stamp of the peer on this process's clock, but not later than now: what has not happened yet
  /// would have a negative age.
  Time here(std::int64_t stamp) const;
  /// The same of all stamps in a slot that has arrived. `shift`: null if it has none.
  void bringHere(StampShift shift, std::byte* slot) const;

  bool hasRoom() const { return window_.isOpen() && socket_->hasRoom(); }
  /// Memory for the payload; finish() ends the frame. Only if hasRoom().
  std::byte* begin(Header header, std::size_t size);
  void finish() { socket_->finish(); }
  void send(const Header& header, std::span<const std::byte> payload = {});

  const std::shared_ptr<Channel> channel_;

 private:
  const std::uint32_t number_;
  FrameSocket* socket_ = nullptr;
  Window window_;
  std::string why_;
  std::atomic<bool> broken_{false};
};

}  // namespace suture::frame
