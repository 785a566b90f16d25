#pragma once
// A connected socket that carries frames.

#include <suture/lane/frame/bytes/frame_reader.h>
#include <suture/lane/frame/bytes/frame_writer.h>
#include <suture/net/byte_stream.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace suture::frame {

/// Sends and receives frames. Never blocks. Belongs to the lane thread.
class FrameSocket {
 public:
  FrameSocket(rpc::ByteStream bytes, std::uint32_t epoch);

  int descriptor() const { return bytes_.socket(); }

  /// True if one more frame may be sent.
  bool hasRoom() const { return writer_.hasRoom(); }
  /// Memory for the payload, all zero; finish() ends the frame. Only if hasRoom().
  std::byte* begin(const Header& header, std::size_t size) { return writer_.begin(header, size); }
  void finish() { writer_.finish(); }

  /// The socket tells that something has arrived: receive() looks.
  void arrived() { empty_ = false; }
  bool mayHaveMore() const { return !empty_ && !broken(); }
  /// Fetches some of it; false: there is nothing. Ends what next() returned.
  bool receive();
  /// The next frame of what receive() has fetched, nullptr: none. Valid until the next call.
  const Header* next();
  std::span<std::byte> payload() { return reader_.payload(); }

  /// Sends what the socket takes.
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

 private:
  const std::uint32_t epoch_;
  rpc::ByteStream bytes_;
  FrameReader reader_;
  FrameWriter writer_;
  bool empty_ = false;  // nothing has arrived that has not been received
  std::string why_;
};

}  // namespace suture::frame
