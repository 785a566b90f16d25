#pragma once
// A connected socket that carries frames.

#include <suture/transport/frame/frame_reader.h>
#include <suture/transport/frame/frame_writer.h>
#include <suture/transport/rpc/byte_stream.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace suture::frame {

/// Sends and receives frames, with at most kWindow under way that the other end has not taken: a
/// peer that is stopped finds no more than those when it goes on. Never blocks. Belongs to the lane
/// thread.
class FrameSocket {
 public:
  static constexpr std::uint32_t kWindow = 32;

  FrameSocket(rpc::ByteStream bytes, std::uint32_t epoch, std::size_t mostPayload);

  int descriptor() const { return bytes_.socket(); }

  /// True if one more frame may be sent.
  bool hasRoom() const { return sent_ - acknowledged_ < kWindow && writer_.hasRoom(); }
  /// Memory for the payload; finish() ends the frame. Only if hasRoom().
  std::byte* begin(Header header, std::size_t size);
  void finish() { writer_.finish(); }

  /// The socket tells that something has arrived: next() looks.
  void arrived() { empty_ = false; }
  /// The next frame that has arrived, nullptr: none. Valid until the next call.
  const Header* next();
  std::span<std::byte> payload() { return reader_.payload(); }

  /// Tells the other end, if need be, what has been taken, and sends what the socket takes.
  void flush();
  /// There is more to send than the socket took: it tells when it takes more.
  bool isFull() const { return !writer_.unsent().empty(); }

  /// The socket is of no more use to either end.
  void cut() { bytes_.cut(); }
  /// Nothing is sent or received any more; `why` in words.
  void breakOff(std::string why) { why_ = std::move(why); }
  bool broken() const { return !why_.empty(); }
  /// Why nothing comes or goes any more, in words; "" if it does.
  const std::string& why() const { return why_; }

  std::uint64_t sentBytes() const { return sentBytes_; }
  std::uint64_t receivedBytes() const { return receivedBytes_; }

 private:
  void receive();

  const std::uint32_t epoch_;
  rpc::ByteStream bytes_;
  FrameReader reader_;
  FrameWriter writer_;
  // Frames but for Acknowledge; they count beyond 2^32 from zero again.
  std::uint32_t sent_ = 0, acknowledged_ = 0;  // ours, and of these taken by the other end
  std::uint32_t taken_ = 0, told_ = 0;         // theirs, and of these acknowledged
  bool empty_ = false;                         // nothing has arrived that has not been received
  std::uint64_t sentBytes_ = 0, receivedBytes_ = 0;
  std::string why_;
};

}  // namespace suture::frame
