// Written by suturec from vision/stereo_images.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "vision/stereo_images.capnp.h"
#include "vision/stereo_images.suture.h"

// Defined in robot_types/vision.wire.cpp.
namespace robots {
void toWire(const ImageFrameSlot& slot, wire::ImageFrame::Builder out);
suture::Errc fromWire(wire::ImageFrame::Reader in, ImageFrameSlot& slot, suture::Duration shift);
}  // namespace robots

namespace robots {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const StereoPairSlot& slot, wire::StereoPair::Builder out) {
  toWire(slot.left, out.initLeft());
  toWire(slot.right, out.initRight());
}

suture::Errc fromWire(wire::StereoPair::Reader in, StereoPairSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getLeft(), slot.left, shift),
      fromWire(in.getRight(), slot.right, shift),
  });
}

// --- StereoImages as Cap'n Proto

namespace {

void encodeStereoImagesImagesResult(const StereoPairSlot& slot,
                                    wire::StereoImages::ImagesResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeStereoImagesImagesResult(wire::StereoImages::ImagesResults::Reader in,
                                            StereoPairSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeStereoImagesExposedResult(const std::int64_t& slot,
                                     wire::StereoImages::ExposedResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeStereoImagesExposedResult(wire::StereoImages::ExposedResults::Reader in,
                                             std::int64_t& slot, suture::Duration shift) {
  slot = suture::codec::shifted(in.getValue(), shift);
  return suture::Errc{};
}

void encodeStereoImagesImagesColumn(const StereoPairSlot& slot,
                                    wire::StereoImagesStateRow::Builder out) {
  toWire(slot, out.initImages());
}
suture::Errc decodeStereoImagesImagesColumn(wire::StereoImagesStateRow::Reader in,
                                            StereoPairSlot& slot, suture::Duration shift) {
  return in.hasImages() ? fromWire(in.getImages(), slot, shift) : suture::Errc::Invalid;
}

void encodeStereoImagesExposedColumn(const std::int64_t& slot,
                                     wire::StereoImagesStateRow::Builder out) {
  out.setExposed(slot);
}
suture::Errc decodeStereoImagesExposedColumn(wire::StereoImagesStateRow::Reader in,
                                             std::int64_t& slot, suture::Duration shift) {
  slot = suture::codec::shifted(in.getExposed(), shift);
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeStereoImagesColumn(unsigned column, const std::byte* memory,
                              wire::StereoImagesStateRow::Builder out) {
  switch (column) {
    case StereoImagesColumn::images:
      return encodeStereoImagesImagesColumn(suture::slotIn<StereoPairSlot>(memory), out);
    case StereoImagesColumn::exposed:
      return encodeStereoImagesExposedColumn(suture::slotIn<std::int64_t>(memory), out);
  }
}
suture::Errc decodeStereoImagesColumn(wire::StereoImagesStateRow::Reader in, unsigned column,
                                      std::byte* memory, suture::Duration shift) {
  switch (column) {
    case StereoImagesColumn::images:
      return decodeStereoImagesImagesColumn(in, suture::newSlot<StereoPairSlot>(memory), shift);
    case StereoImagesColumn::exposed:
      return decodeStereoImagesExposedColumn(in, suture::newSlot<std::int64_t>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kStereoImagesCommandCodecs[] = {
    {.interface = capnp::typeId<wire::StereoImages>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::StereoImages::ImagesParams>,
     .result = suture::codec::messageOf<wire::StereoImages::ImagesResults, StereoPairSlot,
                                        encodeStereoImagesImagesResult,
                                        decodeStereoImagesImagesResult>,
     .stamp = suture::codec::stampIn<wire::StereoImages::ImagesResults>},
    {.interface = capnp::typeId<wire::StereoImages>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::StereoImages::ExposedParams>,
     .result = suture::codec::messageOf<wire::StereoImages::ExposedResults, std::int64_t,
                                        encodeStereoImagesExposedResult,
                                        decodeStereoImagesExposedResult>,
     .stamp = suture::codec::stampIn<wire::StereoImages::ExposedResults>},
};

}  // namespace

const suture::codec::Codec& stereoImagesCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::StereoImages>,
      .contract = capnp::typeId<wire::StereoImages>(),
      .subscriber = capnp::typeId<wire::StereoImagesEvents>(),
      .commands = kStereoImagesCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::StereoImagesEvents::StateParams, wire::StereoImagesStateRow,
                                  encodeStereoImagesColumn, decodeStereoImagesColumn>,
  };
  return kCodec;
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::StereoPair& value) {
  return codec::encodeAs<robots::wire::StereoPair, robots::StereoPairSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::StereoPair& value) {
  return codec::decodeAs<robots::wire::StereoPair, robots::StereoPairSlot>(bytes, value);
}

}  // namespace suture
