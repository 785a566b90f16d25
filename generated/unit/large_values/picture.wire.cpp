// Written by suturec from unit/large_values/picture.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "unit/large_values/picture.capnp.h"
#include "unit/large_values/picture.suture.h"

namespace large_values {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const PictureSlot& slot, wire::Picture::Builder out) {
  toWire(slot.pixels, out.initPixels(sizeOf(slot.pixels)));
}

suture::Errc fromWire(wire::Picture::Reader in, PictureSlot& slot, suture::Duration) {
  return fromWire(in.getPixels(), slot.pixels);
}

// --- Gallery as Cap'n Proto

namespace {

void encodeGalleryNewestResult(const PictureSlot& slot, wire::Gallery::NewestResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeGalleryNewestResult(wire::Gallery::NewestResults::Reader in, PictureSlot& slot,
                                       suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeGalleryOldestResult(const PictureSlot& slot, wire::Gallery::OldestResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeGalleryOldestResult(wire::Gallery::OldestResults::Reader in, PictureSlot& slot,
                                       suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeGalleryDimmed(const GalleryDimmedArguments& slot,
                         wire::Gallery::DimmedParams::Builder out) {
  toWire(slot.picture, out.initPicture());
}
suture::Errc decodeGalleryDimmed(wire::Gallery::DimmedParams::Reader in,
                                 GalleryDimmedArguments& slot, suture::Duration shift) {
  return in.hasPicture() ? fromWire(in.getPicture(), slot.picture, shift) : suture::Errc::Invalid;
}

void encodeGalleryDimmedResult(const PictureSlot& slot, wire::Gallery::DimmedResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeGalleryDimmedResult(wire::Gallery::DimmedResults::Reader in, PictureSlot& slot,
                                       suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeGalleryHang(const GalleryHangArguments& slot, wire::Gallery::HangParams::Builder out) {
  toWire(slot.picture, out.initPicture());
}
suture::Errc decodeGalleryHang(wire::Gallery::HangParams::Reader in, GalleryHangArguments& slot,
                               suture::Duration shift) {
  return in.hasPicture() ? fromWire(in.getPicture(), slot.picture, shift) : suture::Errc::Invalid;
}

void encodeGalleryHungEvent(const PictureSlot& slot, wire::GalleryEvents::HungParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeGalleryHungEvent(wire::GalleryEvents::HungParams::Reader in, PictureSlot& slot,
                                    suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeGalleryNewestColumn(const PictureSlot& slot, wire::GalleryStateRow::Builder out) {
  toWire(slot, out.initNewest());
}
suture::Errc decodeGalleryNewestColumn(wire::GalleryStateRow::Reader in, PictureSlot& slot,
                                       suture::Duration shift) {
  return in.hasNewest() ? fromWire(in.getNewest(), slot, shift) : suture::Errc::Invalid;
}

void encodeGalleryOldestColumn(const PictureSlot& slot, wire::GalleryStateRow::Builder out) {
  toWire(slot, out.initOldest());
}
suture::Errc decodeGalleryOldestColumn(wire::GalleryStateRow::Reader in, PictureSlot& slot,
                                       suture::Duration shift) {
  return in.hasOldest() ? fromWire(in.getOldest(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeGalleryColumn(unsigned column, const std::byte* memory,
                         wire::GalleryStateRow::Builder out) {
  switch (column) {
    case GalleryColumn::newest:
      return encodeGalleryNewestColumn(suture::slotIn<PictureSlot>(memory), out);
    case GalleryColumn::oldest:
      return encodeGalleryOldestColumn(suture::slotIn<PictureSlot>(memory), out);
  }
}
suture::Errc decodeGalleryColumn(wire::GalleryStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case GalleryColumn::newest:
      return decodeGalleryNewestColumn(in, suture::newSlot<PictureSlot>(memory), shift);
    case GalleryColumn::oldest:
      return decodeGalleryOldestColumn(in, suture::newSlot<PictureSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kGalleryCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Gallery>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Gallery::NewestParams>,
     .result = suture::codec::messageOf<wire::Gallery::NewestResults, PictureSlot,
                                        encodeGalleryNewestResult, decodeGalleryNewestResult>,
     .stamp = suture::codec::stampIn<wire::Gallery::NewestResults>},
    {.interface = capnp::typeId<wire::Gallery>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Gallery::OldestParams>,
     .result = suture::codec::messageOf<wire::Gallery::OldestResults, PictureSlot,
                                        encodeGalleryOldestResult, decodeGalleryOldestResult>,
     .stamp = suture::codec::stampIn<wire::Gallery::OldestResults>},
    {.interface = capnp::typeId<wire::Gallery>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Gallery::DimmedParams>,
     .arguments = suture::codec::messageOf<wire::Gallery::DimmedParams, GalleryDimmedArguments,
                                           encodeGalleryDimmed, decodeGalleryDimmed>,
     .result = suture::codec::messageOf<wire::Gallery::DimmedResults, PictureSlot,
                                        encodeGalleryDimmedResult, decodeGalleryDimmedResult>},
    {.interface = capnp::typeId<wire::Gallery>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Gallery::HangParams>,
     .arguments = suture::codec::messageOf<wire::Gallery::HangParams, GalleryHangArguments,
                                           encodeGalleryHang, decodeGalleryHang>},
};

constexpr suture::codec::EventCodec kGalleryEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::GalleryEvents::HungParams>,
     .payload = suture::codec::messageOf<wire::GalleryEvents::HungParams, PictureSlot,
                                         encodeGalleryHungEvent, decodeGalleryHungEvent>},
};

}  // namespace

const suture::codec::Codec& galleryCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Gallery>,
      .contract = capnp::typeId<wire::Gallery>(),
      .subscriber = capnp::typeId<wire::GalleryEvents>(),
      .commands = kGalleryCommandCodecs,
      .events = kGalleryEventCodecs,
      .row = suture::codec::rowOf<wire::GalleryEvents::StateParams, wire::GalleryStateRow,
                                  encodeGalleryColumn, decodeGalleryColumn>,
  };
  return kCodec;
}

}  // namespace large_values

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const large_values::Picture& value) {
  return codec::encodeAs<large_values::wire::Picture, large_values::PictureSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, large_values::Picture& value) {
  return codec::decodeAs<large_values::wire::Picture, large_values::PictureSlot>(bytes, value);
}

}  // namespace suture
