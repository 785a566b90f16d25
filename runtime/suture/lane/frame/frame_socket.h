#pragma once
// This is a connected socket that carries frames.

#include <suture/lane/frame/bytes/frame_reader.h>
#include <suture/lane/frame/bytes/frame_writer.h>
#include <suture/net/byte_stream.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace suture::frame {

/// Belongs to the lane thread. Sends and receives frames; never blocks.
class FrameSocket {
 public:
  FrameSocket(net::ByteStream bytes, std::uint32_t epoch);

  int descriptor() const { return bytes_.socket(); }

  /// Returns true if one more frame may be sent.
  bool hasRoom() const { return writer_.hasRoom(); }
  /// Call it only if hasRoom(). Returns memory for the payload; finish() ends the frame.
  std::byte* begin(const Header& header, std::size_t size) { return writer_.begin(header, size); }
  void finish() { writer_.finish(); }

  /// Call it when the socket says that something has arrived, so that receive() reads it.
  void arrived() { empty_ = false; }
  bool mayHaveMore() const { return !empty_ && !broken(); }
  /// Fetches some of it, and invalidates what next() returned. Returns false if there is nothing.
  bool receive();
  /// Returns the next frame of what receive() has fetched, or nullptr; it is valid until the next
  /// call.
  const Header* next();
  std::span<std::byte> payload() { return reader_.payload(); }

  /// Sends what the socket takes.
  void flush();
  /// Returns true if there is more to send than the socket took; the socket tells when it takes
  /// more.
  bool isFull() const { return !writer_.unsent().empty(); }

  /// Makes the socket useless to both ends.
  void cut() { bytes_.cut(); }
  /// Ends sending and receiving; `why` says the reason in words.
  void breakOff(std::string why) { why_ = std::move(why); }
  /// Does the same because of what the peer sent.
  void refuse(std::string why) {
    refusal_ = why;
    breakOff(std::move(why));
  }
  bool broken() const { return !why_.empty(); }
  /// Returns why nothing comes or goes any more, in words; "" if it does.
  const std::string& why() const { return why_; }
  /// Returns what of the peer was refused, in words; "" if nothing was.
  const std::string& refusal() const { return refusal_; }

 private:
  const std::uint32_t epoch_;
  net::ByteStream bytes_;
  FrameReader reader_;
  FrameWriter writer_;
  bool empty_ = false;  // nothing has arrived that has not been received
  std::string why_, refusal_;
};

}  // namespace suture::frame
