// Written by suturec from bench/block_loop.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "bench/block_loop.capnp.h"
#include "bench/block_loop.suture.h"

namespace bench {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const SmallBlockSlot& slot, wire::SmallBlock::Builder out) {
  toWire(slot.bytes, out.initBytes(sizeOf(slot.bytes)));
}

suture::Errc fromWire(wire::SmallBlock::Reader in, SmallBlockSlot& slot, suture::Duration) {
  return fromWire(in.getBytes(), slot.bytes);
}

void toWire(const LargeBlockSlot& slot, wire::LargeBlock::Builder out) {
  toWire(slot.bytes, out.initBytes(sizeOf(slot.bytes)));
}

suture::Errc fromWire(wire::LargeBlock::Reader in, LargeBlockSlot& slot, suture::Duration) {
  return fromWire(in.getBytes(), slot.bytes);
}

// --- SmallBlocks as Cap'n Proto

namespace {

void encodeSmallBlocksBounce(const SmallBlocksBounceArguments& slot,
                             wire::SmallBlocks::BounceParams::Builder out) {
  toWire(slot.block, out.initBlock());
}
suture::Errc decodeSmallBlocksBounce(wire::SmallBlocks::BounceParams::Reader in,
                                     SmallBlocksBounceArguments& slot, suture::Duration shift) {
  return in.hasBlock() ? fromWire(in.getBlock(), slot.block, shift) : suture::Errc::Invalid;
}

void encodeSmallBlocksEchoEvent(const SmallBlockSlot& slot,
                                wire::SmallBlocksEvents::EchoParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeSmallBlocksEchoEvent(wire::SmallBlocksEvents::EchoParams::Reader in,
                                        SmallBlockSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kSmallBlocksCommandCodecs[] = {
    {.interface = capnp::typeId<wire::SmallBlocks>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::SmallBlocks::BounceParams>,
     .arguments = suture::codec::messageOf<wire::SmallBlocks::BounceParams,
                                           SmallBlocksBounceArguments, encodeSmallBlocksBounce,
                                           decodeSmallBlocksBounce>},
};

constexpr suture::codec::EventCodec kSmallBlocksEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::SmallBlocksEvents::EchoParams>,
     .payload = suture::codec::messageOf<wire::SmallBlocksEvents::EchoParams, SmallBlockSlot,
                                         encodeSmallBlocksEchoEvent, decodeSmallBlocksEchoEvent>},
};

}  // namespace

const suture::codec::Codec& smallBlocksCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::SmallBlocks>,
      .contract = capnp::typeId<wire::SmallBlocks>(),
      .subscriber = capnp::typeId<wire::SmallBlocksEvents>(),
      .commands = kSmallBlocksCommandCodecs,
      .events = kSmallBlocksEventCodecs,
      .row = suture::codec::rowOf<wire::SmallBlocksEvents::StateParams, wire::SmallBlocksStateRow>,
  };
  return kCodec;
}

// --- LargeBlocks as Cap'n Proto

namespace {

void encodeLargeBlocksBounce(const LargeBlocksBounceArguments& slot,
                             wire::LargeBlocks::BounceParams::Builder out) {
  toWire(slot.block, out.initBlock());
}
suture::Errc decodeLargeBlocksBounce(wire::LargeBlocks::BounceParams::Reader in,
                                     LargeBlocksBounceArguments& slot, suture::Duration shift) {
  return in.hasBlock() ? fromWire(in.getBlock(), slot.block, shift) : suture::Errc::Invalid;
}

void encodeLargeBlocksEchoEvent(const LargeBlockSlot& slot,
                                wire::LargeBlocksEvents::EchoParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeLargeBlocksEchoEvent(wire::LargeBlocksEvents::EchoParams::Reader in,
                                        LargeBlockSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kLargeBlocksCommandCodecs[] = {
    {.interface = capnp::typeId<wire::LargeBlocks>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::LargeBlocks::BounceParams>,
     .arguments = suture::codec::messageOf<wire::LargeBlocks::BounceParams,
                                           LargeBlocksBounceArguments, encodeLargeBlocksBounce,
                                           decodeLargeBlocksBounce>},
};

constexpr suture::codec::EventCodec kLargeBlocksEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::LargeBlocksEvents::EchoParams>,
     .payload = suture::codec::messageOf<wire::LargeBlocksEvents::EchoParams, LargeBlockSlot,
                                         encodeLargeBlocksEchoEvent, decodeLargeBlocksEchoEvent>},
};

}  // namespace

const suture::codec::Codec& largeBlocksCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::LargeBlocks>,
      .contract = capnp::typeId<wire::LargeBlocks>(),
      .subscriber = capnp::typeId<wire::LargeBlocksEvents>(),
      .commands = kLargeBlocksCommandCodecs,
      .events = kLargeBlocksEventCodecs,
      .row = suture::codec::rowOf<wire::LargeBlocksEvents::StateParams, wire::LargeBlocksStateRow>,
  };
  return kCodec;
}

}  // namespace bench

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const bench::SmallBlock& value) {
  return codec::encodeAs<bench::wire::SmallBlock, bench::SmallBlockSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, bench::SmallBlock& value) {
  return codec::decodeAs<bench::wire::SmallBlock, bench::SmallBlockSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const bench::LargeBlock& value) {
  return codec::encodeAs<bench::wire::LargeBlock, bench::LargeBlockSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, bench::LargeBlock& value) {
  return codec::decodeAs<bench::wire::LargeBlock, bench::LargeBlockSlot>(bytes, value);
}

}  // namespace suture
