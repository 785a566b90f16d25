#include <suture/lane/frame/payloads/encoded_payloads.h>

#include <capnp/serialize.h>
#include <kj/exception.h>

namespace suture::frame {
namespace {

// A newer peer's values may be larger than this process knows, but not larger than a message of the
// control plane.
constexpr std::size_t kLimit = std::size_t{16} << 20;

// A message has pointers and sizes beside its values; those of most contracts fit into this.
constexpr std::size_t kHeadWords = 64;

std::size_t words(std::size_t bytes) { return wordBytes(bytes) / sizeof(capnp::word); }

/// Calls `read` with the root of a message of one segment, and returns silently if it is malformed.
template <class Read>
void readMessage(std::span<const std::byte> payload, const Read& read) {
  static constexpr capnp::word kNothing{};
  kj::ArrayPtr<const capnp::word> segment(&kNothing, 1);
  if (!payload.empty()) {
    segment = kj::arrayPtr(reinterpret_cast<const capnp::word*>(payload.data()),
                           payload.size() / sizeof(capnp::word));
  }
  // An exception would end the thread, and with it all connections.
  kj::runCatchingExceptions([&] {
    capnp::SegmentArrayMessageReader message(kj::arrayPtr(&segment, 1));
    read(message.getRoot<capnp::AnyPointer>());
  });
}

}  // namespace

EncodedPayloads::EncodedPayloads(const InterfaceInfo& contract)
    : contract_(contract),
      row_(contract),
      scratch_(kHeadWords + 2 * words(std::max<std::size_t>(largestSlot(contract), row_.bytes()))),
      slot_(std::max<std::size_t>(words(largestSlot(contract)), 1)),  // null would mean no value
      values_(row_.columns()) {}

std::size_t EncodedPayloads::limit() const { return kLimit; }

const codec::MessageCodec& EncodedPayloads::codecOf(ValueName name) const {
  const codec::Codec& codec = contract_.codec();
  if (name.kind == Kind::Event) return codec.events[name.number].payload;
  const codec::CommandCodec& command = codec.commands[name.number];
  return name.kind == Kind::Reply ? command.result : command.arguments;
}

template <class Encode>
std::span<const std::byte> EncodedPayloads::packed(const Encode& encode) {
  for (;;) {
    message_.reset();  // which leaves scratch_ zero
    message_.emplace(kj::arrayPtr(scratch_.data(), scratch_.size()));
    encode(message_->getRoot<capnp::AnyPointer>());
    const auto segments = message_->getSegmentsForOutput();
    if (segments.size() == 1) {
      const auto bytes = segments[0].asBytes();
      return {reinterpret_cast<const std::byte*>(bytes.begin()), bytes.size()};
    }
    std::size_t all = 0;
    for (const auto& segment : segments) all += segment.size();
    message_.reset();
    scratch_ = std::vector<capnp::word>(2 * all);
  }
}

std::span<const std::byte> EncodedPayloads::pack(ValueName name, const std::byte* slot) {
  return packed([&](capnp::AnyPointer::Builder out) { codecOf(name).encode(slot, out); });
}

std::span<const std::byte> EncodedPayloads::packRow(const rt::StateTable::Row& row) {
  return packed([&](capnp::AnyPointer::Builder out) {
    contract_.codec().row.encode(row, row_.slots(), contract_.wireColumns, out);
  });
}

ArrivedValue EncodedPayloads::open(ValueName name, std::span<std::byte> payload, Duration shift) {
  auto* const slot = reinterpret_cast<std::byte*>(slot_.data());
  ArrivedValue value{slot, Errc::Invalid};
  readMessage(payload, [&](capnp::AnyPointer::Reader in) {
    value.error = codecOf(name).decode(in, slot, shift);
  });
  return value;
}

std::optional<ArrivedRow> EncodedPayloads::openRow(std::span<std::byte> payload, Duration shift,
                                                   rt::StateTable& mirror) {
  ArrivedRow row{.columns = {}, .values = values_};
  readMessage(payload, [&](capnp::AnyPointer::Reader in) {
    row.columns = contract_.codec().row.decode(in, contract_.wireColumns, shift, mirror);
  });
  for (unsigned i = 0; i < values_.size(); ++i) values_[i] = {mirror.draft(i)};
  return row;
}

}  // namespace suture::frame
