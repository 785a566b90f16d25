#pragma once
// This is a message that has arrived whole and owns its bytes.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/message.h>
#include <capnp/rpc.h>
#include <kj/io.h>
#include <suture/framing/frame_header.h>

namespace suture::framing {

/// Belongs to the control thread. Reads the segments of one frame.
class ReceivedMessage final : public capnp::MessageReader, public capnp::IncomingRpcMessage {
 public:
  /// `frame` is a whole frame, starting with its header.
  ReceivedMessage(kj::Array<capnp::word> frame, const FrameHeader& header,
                  capnp::ReaderOptions limits, kj::Array<kj::AutoCloseFd> descriptors = nullptr)
      : MessageReader(limits),
        frame_(kj::mv(frame)),
        header_(header),
        descriptors_(kj::mv(descriptors)) {}

  kj::ArrayPtr<const capnp::word> getSegment(capnp::uint id) override {
    if (id >= header_.segments) return nullptr;
    const auto bytes = std::as_bytes(std::span(frame_.begin(), frame_.size()));
    std::size_t start = header_.headerBytes / sizeof(capnp::word);
    for (std::uint32_t i = 0; i < id; ++i) start += segmentWords(bytes, i);
    return frame_.slice(start, start + segmentWords(bytes, id));
  }

  capnp::AnyPointer::Reader getBody() override { return getRoot<capnp::AnyPointer>(); }
  std::size_t sizeInWords() override { return frame_.size(); }
  kj::ArrayPtr<kj::AutoCloseFd> getAttachedFds() override { return descriptors_; }

 private:
  kj::Array<capnp::word> frame_;
  FrameHeader header_;
  kj::Array<kj::AutoCloseFd> descriptors_;
};

}  // namespace suture::framing
