#pragma once
// One connection over frames, as either process sees it.

#include <suture/component/channel.h>
#include <suture/transport/frame/frame_socket.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace suture::frame {

/// Two processes may exchange the slots of a contract as they lie in memory if their layouts are
/// equal, see memoryLayout(). Values of a peer are judged before a component sees them.
std::size_t mostPayload(const InterfaceInfo& contract);

/// How the two ends of a connection agree.
struct Terms {
  std::uint32_t epoch = 0;  ///< in every frame
  Duration shift{0};        ///< turns the peer's steady clock into this process's
};

/// Carries everything between a channel and a socket. Belongs to the lane thread, but for what is
/// said to be any thread's.
class Connection {
 public:
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  int descriptor() const { return socket_.descriptor(); }
  /// The socket tells that something has arrived.
  void arrived() { socket_.arrived(); }
  /// Takes what has come from either side, and gives it to the other.
  void turn();
  /// The socket has not taken all, and tells when it takes more.
  bool isFull() const { return socket_.isFull(); }
  /// There is nothing to carry any more.
  bool over() const;
  /// The other end is told so.
  void end() { socket_.cut(); }

  /// Any thread: the socket carries nothing any more. Then the channel's watcher has been rung.
  bool broken() const { return broken_.load(std::memory_order_acquire); }
  /// Any thread, once broken(): why, in words.
  const std::string& why() const { return socket_.why(); }

 protected:
  Connection(std::shared_ptr<Channel> channel, rpc::ByteStream bytes, const Terms& terms);

  /// A frame of the peer; false if there can be no such.
  virtual bool take(const Header& header, std::span<std::byte> payload) = 0;
  /// Behind all that have arrived.
  virtual void taken() {}
  /// Sends what the channel has, as far as there is room.
  virtual void give() = 0;

  /// A stamp of the peer on this process's clock. What has not happened yet would have a negative
  /// age.
  Time here(std::int64_t stamp) const;
  /// The same of all stamps in a slot that has arrived. `shift`: null if it has none.
  void bringHere(StampShift shift, std::byte* slot) const;
  void send(const Header& header, std::span<const std::byte> payload = {});

  const std::shared_ptr<Channel> channel_;
  FrameSocket socket_;

 private:
  void receive();

  const Duration shift_;
  std::atomic<bool> broken_{false};
};

}  // namespace suture::frame
