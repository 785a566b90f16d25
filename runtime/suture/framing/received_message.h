#pragma once
// This is a message that has arrived whole and owns its bytes.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/message.h>
#include <capnp/rpc.h>
#include <kj/io.h>
#include <suture/framing/message_header.h>

namespace suture::framing {

/// Belongs to the control thread. Reads the segments of one message.
class ReceivedMessage final : public capnp::MessageReader, public capnp::IncomingRpcMessage {
 public:
  /// `bytes` is a whole message, starting with its header.
  ReceivedMessage(kj::Array<capnp::word> bytes, const MessageHeader& header,
                  capnp::ReaderOptions limits, kj::Array<kj::AutoCloseFd> descriptors = nullptr)
      : MessageReader(limits),
        bytes_(kj::mv(bytes)),
        header_(header),
        descriptors_(kj::mv(descriptors)) {}

  kj::ArrayPtr<const capnp::word> getSegment(capnp::uint id) override {
    if (id >= header_.segments) return nullptr;
    const auto bytes = std::as_bytes(std::span(bytes_.begin(), bytes_.size()));
    std::size_t start = header_.headerBytes / sizeof(capnp::word);
    for (std::uint32_t i = 0; i < id; ++i) start += segmentWords(bytes, i);
    return bytes_.slice(start, start + segmentWords(bytes, id));
  }

  capnp::AnyPointer::Reader getBody() override { return getRoot<capnp::AnyPointer>(); }
  std::size_t sizeInWords() override { return bytes_.size(); }
  kj::ArrayPtr<kj::AutoCloseFd> getAttachedFds() override { return descriptors_; }

 private:
  kj::Array<capnp::word> bytes_;
  MessageHeader header_;
  kj::Array<kj::AutoCloseFd> descriptors_;
};

}  // namespace suture::framing
