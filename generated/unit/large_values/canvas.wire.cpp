// Written by suturec from unit/large_values/canvas.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "unit/large_values/canvas.capnp.h"
#include "unit/large_values/canvas.suture.h"

namespace large_values {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const DotSlot& slot, wire::Dot::Builder out) {
  out.setShade(slot.shade);
}

suture::Errc fromWire(wire::Dot::Reader in, DotSlot& slot, suture::Duration) {
  slot.shade = in.getShade();
  return suture::Errc{};
}

void toWire(const DotsSlot& slot, wire::Dots::Builder out) {
  suture::codec::toWireList(slot.dots, out.initDots(sizeOf(slot.dots)),
                            [](const DotSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
}

suture::Errc fromWire(wire::Dots::Reader in, DotsSlot& slot, suture::Duration shift) {
  return suture::codec::fromWireList(in.getDots(), slot.dots, [&](auto item, DotSlot& target) {
    return fromWire(item, target, shift);
  });
}

// --- Canvas as Cap'n Proto

namespace {

void encodeCanvasResize(const CanvasResizeArguments& slot,
                        wire::Canvas::ResizeParams::Builder out) {
  out.setDots(slot.dots);
}
suture::Errc decodeCanvasResize(wire::Canvas::ResizeParams::Reader in, CanvasResizeArguments& slot,
                                suture::Duration) {
  slot.dots = in.getDots();
  return suture::Errc{};
}

void encodeCanvasPaint(const CanvasPaintArguments& slot, wire::Canvas::PaintParams::Builder out) {
  toWire(slot.dots, out.initDots());
}
suture::Errc decodeCanvasPaint(wire::Canvas::PaintParams::Reader in, CanvasPaintArguments& slot,
                               suture::Duration shift) {
  return in.hasDots() ? fromWire(in.getDots(), slot.dots, shift) : suture::Errc::Invalid;
}

void encodeCanvasPaintingResult(const DotsSlot& slot, wire::Canvas::PaintingResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeCanvasPaintingResult(wire::Canvas::PaintingResults::Reader in, DotsSlot& slot,
                                        suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeCanvasCopy(const CanvasCopyArguments& slot, wire::Canvas::CopyParams::Builder out) {
  out.setDots(slot.dots);
}
suture::Errc decodeCanvasCopy(wire::Canvas::CopyParams::Reader in, CanvasCopyArguments& slot,
                              suture::Duration) {
  slot.dots = in.getDots();
  return suture::Errc{};
}

void encodeCanvasCopyResult(const DotsSlot& slot, wire::Canvas::CopyResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeCanvasCopyResult(wire::Canvas::CopyResults::Reader in, DotsSlot& slot,
                                    suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeCanvasPaintedEvent(const DotsSlot& slot,
                              wire::CanvasEvents::PaintedParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeCanvasPaintedEvent(wire::CanvasEvents::PaintedParams::Reader in, DotsSlot& slot,
                                      suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeCanvasPaintingColumn(const DotsSlot& slot, wire::CanvasStateRow::Builder out) {
  toWire(slot, out.initPainting());
}
suture::Errc decodeCanvasPaintingColumn(wire::CanvasStateRow::Reader in, DotsSlot& slot,
                                        suture::Duration shift) {
  return in.hasPainting() ? fromWire(in.getPainting(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeCanvasColumn(unsigned column, const std::byte* memory,
                        wire::CanvasStateRow::Builder out) {
  switch (column) {
    case CanvasColumn::painting:
      return encodeCanvasPaintingColumn(suture::slotIn<DotsSlot>(memory), out);
  }
}
suture::Errc decodeCanvasColumn(wire::CanvasStateRow::Reader in, unsigned column, std::byte* memory,
                                suture::Duration shift) {
  switch (column) {
    case CanvasColumn::painting:
      return decodeCanvasPaintingColumn(in, suture::newSlot<DotsSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kCanvasCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Canvas>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Canvas::ResizeParams>,
     .arguments = suture::codec::messageOf<wire::Canvas::ResizeParams, CanvasResizeArguments,
                                           encodeCanvasResize, decodeCanvasResize>},
    {.interface = capnp::typeId<wire::Canvas>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Canvas::PaintParams>,
     .arguments = suture::codec::messageOf<wire::Canvas::PaintParams, CanvasPaintArguments,
                                           encodeCanvasPaint, decodeCanvasPaint>},
    {.interface = capnp::typeId<wire::Canvas>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Canvas::PaintingParams>,
     .result = suture::codec::messageOf<wire::Canvas::PaintingResults, DotsSlot,
                                        encodeCanvasPaintingResult, decodeCanvasPaintingResult>,
     .stamp = suture::codec::stampIn<wire::Canvas::PaintingResults>},
    {.interface = capnp::typeId<wire::Canvas>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Canvas::CopyParams>,
     .arguments = suture::codec::messageOf<wire::Canvas::CopyParams, CanvasCopyArguments,
                                           encodeCanvasCopy, decodeCanvasCopy>,
     .result = suture::codec::messageOf<wire::Canvas::CopyResults, DotsSlot, encodeCanvasCopyResult,
                                        decodeCanvasCopyResult>},
};

constexpr suture::codec::EventCodec kCanvasEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::CanvasEvents::PaintedParams>,
     .payload = suture::codec::messageOf<wire::CanvasEvents::PaintedParams, DotsSlot,
                                         encodeCanvasPaintedEvent, decodeCanvasPaintedEvent>},
};

}  // namespace

const suture::codec::Codec& canvasCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Canvas>,
      .contract = capnp::typeId<wire::Canvas>(),
      .subscriber = capnp::typeId<wire::CanvasEvents>(),
      .commands = kCanvasCommandCodecs,
      .events = kCanvasEventCodecs,
      .row = suture::codec::rowOf<wire::CanvasEvents::StateParams, wire::CanvasStateRow,
                                  encodeCanvasColumn, decodeCanvasColumn>,
  };
  return kCodec;
}

}  // namespace large_values

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const large_values::Dot& value) {
  return codec::encodeAs<large_values::wire::Dot, large_values::DotSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, large_values::Dot& value) {
  return codec::decodeAs<large_values::wire::Dot, large_values::DotSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const large_values::Dots& value) {
  return codec::encodeAs<large_values::wire::Dots, large_values::DotsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, large_values::Dots& value) {
  return codec::decodeAs<large_values::wire::Dots, large_values::DotsSlot>(bytes, value);
}

}  // namespace suture
