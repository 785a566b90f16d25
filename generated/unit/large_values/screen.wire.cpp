// Written by suturec from unit/large_values/screen.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "unit/large_values/screen.capnp.h"
#include "unit/large_values/screen.suture.h"

namespace large_values {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const FrameSlot& slot, wire::Frame::Builder out) {
  out.setNumber(slot.number);
  toWire(slot.pixels, out.initPixels(sizeOf(slot.pixels)));
}

suture::Errc fromWire(wire::Frame::Reader in, FrameSlot& slot, suture::Duration) {
  slot.number = in.getNumber();
  return fromWire(in.getPixels(), slot.pixels);
}

void toWire(const FramePairSlot& slot, wire::FramePair::Builder out) {
  toWire(slot.left, out.initLeft());
  toWire(slot.right, out.initRight());
}

suture::Errc fromWire(wire::FramePair::Reader in, FramePairSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getLeft(), slot.left, shift),
      fromWire(in.getRight(), slot.right, shift),
  });
}

// --- Screen as Cap'n Proto

namespace {

void encodeScreenShow(const ScreenShowArguments& slot, wire::Screen::ShowParams::Builder out) {
  toWire(slot.frame, out.initFrame());
}
suture::Errc decodeScreenShow(wire::Screen::ShowParams::Reader in, ScreenShowArguments& slot,
                              suture::Duration shift) {
  return in.hasFrame() ? fromWire(in.getFrame(), slot.frame, shift) : suture::Errc::Invalid;
}

void encodeScreenReplace(const ScreenReplaceArguments& slot,
                         wire::Screen::ReplaceParams::Builder out) {
  toWire(slot.frame, out.initFrame());
}
suture::Errc decodeScreenReplace(wire::Screen::ReplaceParams::Reader in,
                                 ScreenReplaceArguments& slot, suture::Duration shift) {
  return in.hasFrame() ? fromWire(in.getFrame(), slot.frame, shift) : suture::Errc::Invalid;
}

void encodeScreenShowBoth(const ScreenShowBothArguments& slot,
                          wire::Screen::ShowBothParams::Builder out) {
  toWire(slot.frames, out.initFrames());
}
suture::Errc decodeScreenShowBoth(wire::Screen::ShowBothParams::Reader in,
                                  ScreenShowBothArguments& slot, suture::Duration shift) {
  return in.hasFrames() ? fromWire(in.getFrames(), slot.frames, shift) : suture::Errc::Invalid;
}

void encodeScreenShownEvent(const FrameSlot& slot, wire::ScreenEvents::ShownParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeScreenShownEvent(wire::ScreenEvents::ShownParams::Reader in, FrameSlot& slot,
                                    suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeScreenNewestEvent(const FrameSlot& slot, wire::ScreenEvents::NewestParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeScreenNewestEvent(wire::ScreenEvents::NewestParams::Reader in, FrameSlot& slot,
                                     suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeScreenBothEvent(const FramePairSlot& slot, wire::ScreenEvents::BothParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeScreenBothEvent(wire::ScreenEvents::BothParams::Reader in, FramePairSlot& slot,
                                   suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kScreenCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Screen>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Screen::ShowParams>,
     .arguments = suture::codec::messageOf<wire::Screen::ShowParams, ScreenShowArguments,
                                           encodeScreenShow, decodeScreenShow>},
    {.interface = capnp::typeId<wire::Screen>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Screen::ReplaceParams>,
     .arguments = suture::codec::messageOf<wire::Screen::ReplaceParams, ScreenReplaceArguments,
                                           encodeScreenReplace, decodeScreenReplace>},
    {.interface = capnp::typeId<wire::Screen>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Screen::ShowBothParams>,
     .arguments = suture::codec::messageOf<wire::Screen::ShowBothParams, ScreenShowBothArguments,
                                           encodeScreenShowBoth, decodeScreenShowBoth>},
};

constexpr suture::codec::EventCodec kScreenEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::ScreenEvents::ShownParams>,
     .payload = suture::codec::messageOf<wire::ScreenEvents::ShownParams, FrameSlot,
                                         encodeScreenShownEvent, decodeScreenShownEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::ScreenEvents::NewestParams>,
     .payload = suture::codec::messageOf<wire::ScreenEvents::NewestParams, FrameSlot,
                                         encodeScreenNewestEvent, decodeScreenNewestEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::ScreenEvents::BothParams>,
     .payload = suture::codec::messageOf<wire::ScreenEvents::BothParams, FramePairSlot,
                                         encodeScreenBothEvent, decodeScreenBothEvent>},
};

}  // namespace

const suture::codec::Codec& screenCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Screen>,
      .contract = capnp::typeId<wire::Screen>(),
      .subscriber = capnp::typeId<wire::ScreenEvents>(),
      .commands = kScreenCommandCodecs,
      .events = kScreenEventCodecs,
      .row = suture::codec::rowOf<wire::ScreenEvents::StateParams, wire::ScreenStateRow>,
  };
  return kCodec;
}

}  // namespace large_values

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const large_values::Frame& value) {
  return codec::encodeAs<large_values::wire::Frame, large_values::FrameSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, large_values::Frame& value) {
  return codec::decodeAs<large_values::wire::Frame, large_values::FrameSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const large_values::FramePair& value) {
  return codec::encodeAs<large_values::wire::FramePair, large_values::FramePairSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, large_values::FramePair& value) {
  return codec::decodeAs<large_values::wire::FramePair, large_values::FramePairSlot>(bytes, value);
}

}  // namespace suture
