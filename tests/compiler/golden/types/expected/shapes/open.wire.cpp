// Written by suturec from shapes/open.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/flat.h>
#include <suture/codec/wire.h>

#include "shapes/open.capnp.h"
#include "shapes/open.suture.h"

// Defined in shapes/containers.wire.cpp.
namespace shapes {
void toWire(const PointSlot& slot, wire::Point::Builder out);
suture::Errc fromWire(wire::Point::Reader in, PointSlot& slot, suture::Duration shift);
}  // namespace shapes

namespace shapes {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- between slots and Cap'n Proto

void toWire(const RootSlot& slot, wire::Root::Builder out);
suture::Errc fromWire(wire::Root::Reader in, RootSlot& slot, suture::Duration shift);
void toWire(const BranchSlot& slot, wire::Branch::Builder out);
suture::Errc fromWire(wire::Branch::Reader in, BranchSlot& slot, suture::Duration shift);

static void toWire(const suture::OpenOptional<RootSlot>& slot,
                   wire::ShapesOpenOptionalRoot::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(*slot.value, out.initSome());
}

static suture::Errc fromWire(wire::ShapesOpenOptionalRoot::Reader in,
                             suture::OpenOptional<RootSlot>& slot, suture::Duration shift) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  engage(slot);
  return fromWire(in.getSome(), *slot.value, shift);
}

void toWire(const RootSlot& slot, wire::Root::Builder out) {
  out.setValue(slot.value);
  suture::codec::toWireList(slot.children, out.initChildren(sizeOf(slot.children)),
                            [](const RootSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  toWire(slot.shadow, out.initShadow());
  suture::codec::toWireList(slot.branches, out.initBranches(sizeOf(slot.branches)),
                            [](const BranchSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
}

suture::Errc fromWire(wire::Root::Reader in, RootSlot& slot, suture::Duration shift) {
  slot.value = in.getValue();
  return suture::codec::firstError({
      suture::codec::fromWireList(in.getChildren(), slot.children,
                                  [&](auto item, RootSlot& target) {
                                    return fromWire(item, target, shift);
                                  }),
      fromWire(in.getShadow(), slot.shadow, shift),
      suture::codec::fromWireList(in.getBranches(), slot.branches,
                                  [&](auto item, BranchSlot& target) {
                                    return fromWire(item, target, shift);
                                  }),
  });
}

static void toWire(const suture::SlotEntry<suture::OpenText, RootSlot>& slot,
                   wire::ShapesOpenEntryOfTextToRoot::Builder out) {
  toWire(slot.key, out.initKey(sizeOf(slot.key)));
  toWire(slot.value, out.initValue());
}

static suture::Errc fromWire(wire::ShapesOpenEntryOfTextToRoot::Reader in,
                             suture::SlotEntry<suture::OpenText, RootSlot>& slot,
                             suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getKey(), slot.key),
      fromWire(in.getValue(), slot.value, shift),
  });
}

void toWire(const BranchSlot& slot, wire::Branch::Builder out) {
  out.setLength(slot.length);
  suture::codec::toWireList(slot.roots, out.initRoots(sizeOf(slot.roots)),
                            [](const auto& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
}

suture::Errc fromWire(wire::Branch::Reader in, BranchSlot& slot, suture::Duration shift) {
  slot.length = in.getLength();
  return suture::codec::fromWireDistinct(in.getRoots(), slot.roots, [&](auto item, auto& target) {
    return fromWire(item, target, shift);
  });
}

static void toWire(const suture::SlotEntry<suture::OpenText, suture::OpenList<PointSlot>>& slot,
                   wire::ShapesOpenEntryOfTextToListOfPoint::Builder out) {
  toWire(slot.key, out.initKey(sizeOf(slot.key)));
  suture::codec::toWireList(slot.value, out.initValue(sizeOf(slot.value)),
                            [](const PointSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
}

static suture::Errc fromWire(wire::ShapesOpenEntryOfTextToListOfPoint::Reader in,
                             suture::SlotEntry<suture::OpenText, suture::OpenList<PointSlot>>& slot,
                             suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getKey(), slot.key),
      suture::codec::fromWireList(in.getValue(), slot.value, [&](auto item, PointSlot& target) {
        return fromWire(item, target, shift);
      }),
  });
}

static void toWire(const suture::SlotOptional<suture::OpenText>& slot,
                   wire::ShapesOpenOptionalText::Builder out) {
  if (slot.present == 0) return out.setNone();
  toWire(slot.value, out.initSome(sizeOf(slot.value)));
}

static suture::Errc fromWire(wire::ShapesOpenOptionalText::Reader in,
                             suture::SlotOptional<suture::OpenText>& slot, suture::Duration) {
  if (in.isNone()) return slot.present = 0, suture::Errc{};
  if (!in.isSome()) return suture::Errc::Invalid;
  slot.present = 1;
  return fromWire(in.getSome(), slot.value);
}

static void toWire(const suture::SlotVariant<suture::SlotNothing, suture::OpenText, PointSlot>& slot,
                   wire::ShapesOpenEitherOfNothingOrTextOrPoint::Builder out) {
  if (slot.index == 0) return out.setNothing();
  if (slot.index == 1) return toWire(suture::alternative<1>(slot),
                                     out.initText(sizeOf(suture::alternative<1>(slot))));
  if (slot.index == 2) return toWire(suture::alternative<2>(slot), out.initPoint());
}

static suture::Errc fromWire(wire::ShapesOpenEitherOfNothingOrTextOrPoint::Reader in,
                             suture::SlotVariant<suture::SlotNothing, suture::OpenText, PointSlot>& slot,
                             suture::Duration shift) {
  if (in.isNothing()) {
    slot.index = 0;
    return suture::Errc{};
  }
  if (in.isText()) {
    slot.index = 1;
    return fromWire(in.getText(), suture::alternative<1>(slot));
  }
  if (in.isPoint()) {
    slot.index = 2;
    return fromWire(in.getPoint(), suture::alternative<2>(slot), shift);
  }
  return suture::Errc::Invalid;
}

static void toWire(const suture::SlotTuple<std::int32_t, suture::OpenText>& slot,
                   wire::ShapesOpenTupleOfInt32AndText::Builder out) {
  out.setItem0(suture::item<0>(slot));
  toWire(suture::item<1>(slot), out.initItem1(sizeOf(suture::item<1>(slot))));
}

static suture::Errc fromWire(wire::ShapesOpenTupleOfInt32AndText::Reader in,
                             suture::SlotTuple<std::int32_t, suture::OpenText>& slot,
                             suture::Duration) {
  suture::item<0>(slot) = in.getItem0();
  return fromWire(in.getItem1(), suture::item<1>(slot));
}

void toWire(const OpenSlot& slot, wire::Open::Builder out) {
  toWire(slot.name, out.initName(sizeOf(slot.name)));
  toWire(slot.samples, out.initSamples(sizeOf(slot.samples)));
  toWire(slot.bytes, out.initBytes(sizeOf(slot.bytes)));
  toWire(slot.block, out.initBlock(sizeOf(slot.block) * sizeof(float)));
  toWire(slot.flags, out.initFlags(sizeOf(slot.flags)));
  suture::codec::toWireList(slot.path, out.initPath(sizeOf(slot.path)),
                            [](const PointSlot& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  suture::codec::toWireList(slot.pair, out.initPair(2),
                            [](const suture::OpenText& element, auto list, std::uint32_t i) {
                              toWire(element, list.init(i, sizeOf(element)));
                            });
  toWire(slot.words, out.initWords(sizeOf(slot.words)));
  toWire(slot.shorts, out.initShorts(sizeOf(slot.shorts)));
  toWire(slot.keys, out.initKeys(sizeOf(slot.keys)));
  suture::codec::toWireList(slot.series, out.initSeries(sizeOf(slot.series)),
                            [](const auto& element, auto list, std::uint32_t i) {
                              toWire(element, list[i]);
                            });
  toWire(slot.note, out.initNote());
  toWire(slot.either, out.initEither());
  toWire(slot.entry, out.initEntry());
  toWire(slot.joints, out.initJoints(sizeOf(slot.joints)));
  toWire(slot.any, out.initAny());
  toWire(slot.wide, out.initWide());
  suture::codec::toWireFlat(slot.cloud, out.initCloud(sizeOf(slot.cloud) * 3));
  toWire(slot.image, out.initImage());
  toWire(slot.root, out.initRoot());
}

suture::Errc fromWire(wire::Open::Reader in, OpenSlot& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getName(), slot.name),
      fromWire(in.getSamples(), slot.samples),
      fromWire(in.getBytes(), slot.bytes),
      fromWire(in.getBlock(), slot.block),
      fromWire(in.getFlags(), slot.flags),
      suture::codec::fromWireList(in.getPath(), slot.path, [&](auto item, PointSlot& target) {
        return fromWire(item, target, shift);
      }),
      suture::codec::fromWireList(in.getPair(), slot.pair, [](auto item, suture::OpenText& target) {
        return fromWire(item, target);
      }),
      fromWire(in.getWords(), slot.words),
      fromWire(in.getShorts(), slot.shorts),
      suture::codec::fromWireDistinct(in.getKeys(), slot.keys,
                                      [](auto item, suture::OpenText& target) {
                                        return fromWire(item, target);
                                      }),
      suture::codec::fromWireDistinct(in.getSeries(), slot.series, [&](auto item, auto& target) {
        return fromWire(item, target, shift);
      }),
      fromWire(in.getNote(), slot.note, shift),
      fromWire(in.getEither(), slot.either, shift),
      fromWire(in.getEntry(), slot.entry, shift),
      fromWire(in.getJoints(), slot.joints),
      fromWire(in.getAny(), slot.any),
      fromWire(in.getWide(), slot.wide),
      suture::codec::fromWireFlat(in.getCloud(), slot.cloud),
      fromWire(in.getImage(), slot.image),
      fromWire(in.getRoot(), slot.root, shift),
  });
}

// --- Archive as Cap'n Proto

namespace {

void encodeArchivePut(const ArchivePutArguments& slot, wire::Archive::PutParams::Builder out) {
  toWire(slot.key, out.initKey(sizeOf(slot.key)));
  toWire(slot.value, out.initValue());
}
suture::Errc decodeArchivePut(wire::Archive::PutParams::Reader in, ArchivePutArguments& slot,
                              suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getKey(), slot.key),
      in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid,
  });
}

void encodeArchiveRemark(const ArchiveRemarkArguments& slot,
                         wire::Archive::RemarkParams::Builder out) {
  toWire(slot.text, out.initText(sizeOf(slot.text)));
}
suture::Errc decodeArchiveRemark(wire::Archive::RemarkParams::Reader in,
                                 ArchiveRemarkArguments& slot, suture::Duration) {
  return fromWire(in.getText(), slot.text);
}

void encodeArchiveNewestResult(const OpenSlot& slot, wire::Archive::NewestResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArchiveNewestResult(wire::Archive::NewestResults::Reader in, OpenSlot& slot,
                                       suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArchiveFind(const ArchiveFindArguments& slot, wire::Archive::FindParams::Builder out) {
  toWire(slot.pattern, out.initPattern(sizeOf(slot.pattern)));
}
suture::Errc decodeArchiveFind(wire::Archive::FindParams::Reader in, ArchiveFindArguments& slot,
                               suture::Duration) {
  return fromWire(in.getPattern(), slot.pattern);
}

void encodeArchiveFindResult(const suture::OpenList<suture::OpenText>& slot,
                             wire::Archive::FindResults::Builder out) {
  toWire(slot, out.initValue(sizeOf(slot)));
}
suture::Errc decodeArchiveFindResult(wire::Archive::FindResults::Reader in,
                                     suture::OpenList<suture::OpenText>& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeArchiveReplace(const ArchiveReplaceArguments& slot,
                          wire::Archive::ReplaceParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeArchiveReplace(wire::Archive::ReplaceParams::Reader in,
                                  ArchiveReplaceArguments& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeArchiveReplaceResult(const OpenSlot& slot, wire::Archive::ReplaceResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArchiveReplaceResult(wire::Archive::ReplaceResults::Reader in, OpenSlot& slot,
                                        suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArchiveRenamedEvent(const suture::OpenText& slot,
                               wire::ArchiveEvents::RenamedParams::Builder out) {
  toWire(slot, out.initValue(sizeOf(slot)));
}
suture::Errc decodeArchiveRenamedEvent(wire::ArchiveEvents::RenamedParams::Reader in,
                                       suture::OpenText& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeArchiveGrownEvent(const ArchiveGrownPayload& slot,
                             wire::ArchiveEvents::GrownParams::Builder out) {
  toWire(slot.value, out.initValue(sizeOf(slot.value)));
  toWire(slot.value2, out.initValue2());
}
suture::Errc decodeArchiveGrownEvent(wire::ArchiveEvents::GrownParams::Reader in,
                                     ArchiveGrownPayload& slot, suture::Duration shift) {
  return suture::codec::firstError({
      fromWire(in.getValue(), slot.value),
      in.hasValue2() ? fromWire(in.getValue2(), slot.value2, shift) : suture::Errc::Invalid,
  });
}

void encodeArchiveChangedEvent(const OpenSlot& slot,
                               wire::ArchiveEvents::ChangedParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeArchiveChangedEvent(wire::ArchiveEvents::ChangedParams::Reader in,
                                       OpenSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeArchiveNewestColumn(const OpenSlot& slot, wire::ArchiveStateRow::Builder out) {
  toWire(slot, out.initNewest());
}
suture::Errc decodeArchiveNewestColumn(wire::ArchiveStateRow::Reader in, OpenSlot& slot,
                                       suture::Duration shift) {
  return in.hasNewest() ? fromWire(in.getNewest(), slot, shift) : suture::Errc::Invalid;
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeArchiveColumn(unsigned column, const std::byte* memory,
                         wire::ArchiveStateRow::Builder out) {
  switch (column) {
    case ArchiveColumn::newest:
      return encodeArchiveNewestColumn(suture::slotIn<OpenSlot>(memory), out);
  }
}
suture::Errc decodeArchiveColumn(wire::ArchiveStateRow::Reader in, unsigned column,
                                 std::byte* memory, suture::Duration shift) {
  switch (column) {
    case ArchiveColumn::newest:
      return decodeArchiveNewestColumn(in, suture::newSlot<OpenSlot>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kArchiveCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Archive>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Archive::PutParams>,
     .arguments = suture::codec::messageOf<wire::Archive::PutParams, ArchivePutArguments,
                                           encodeArchivePut, decodeArchivePut>},
    {.interface = capnp::typeId<wire::Archive>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Archive::RemarkParams>,
     .arguments = suture::codec::messageOf<wire::Archive::RemarkParams, ArchiveRemarkArguments,
                                           encodeArchiveRemark, decodeArchiveRemark>},
    {.interface = capnp::typeId<wire::Archive>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Archive::NewestParams>,
     .result = suture::codec::messageOf<wire::Archive::NewestResults, OpenSlot,
                                        encodeArchiveNewestResult, decodeArchiveNewestResult>,
     .stamp = suture::codec::stampIn<wire::Archive::NewestResults>},
    {.interface = capnp::typeId<wire::Archive>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Archive::FindParams>,
     .arguments = suture::codec::messageOf<wire::Archive::FindParams, ArchiveFindArguments,
                                           encodeArchiveFind, decodeArchiveFind>,
     .result = suture::codec::messageOf<wire::Archive::FindResults,
                                        suture::OpenList<suture::OpenText>, encodeArchiveFindResult,
                                        decodeArchiveFindResult>},
    {.interface = capnp::typeId<wire::Archive>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::Archive::ReplaceParams>,
     .arguments = suture::codec::messageOf<wire::Archive::ReplaceParams, ArchiveReplaceArguments,
                                           encodeArchiveReplace, decodeArchiveReplace>,
     .result = suture::codec::messageOf<wire::Archive::ReplaceResults, OpenSlot,
                                        encodeArchiveReplaceResult, decodeArchiveReplaceResult>},
};

constexpr suture::codec::EventCodec kArchiveEventCodecs[] = {
    {.method = 1,
     .stamp = suture::codec::stampIn<wire::ArchiveEvents::RenamedParams>,
     .payload = suture::codec::messageOf<wire::ArchiveEvents::RenamedParams, suture::OpenText,
                                         encodeArchiveRenamedEvent, decodeArchiveRenamedEvent>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::ArchiveEvents::GrownParams>,
     .payload = suture::codec::messageOf<wire::ArchiveEvents::GrownParams, ArchiveGrownPayload,
                                         encodeArchiveGrownEvent, decodeArchiveGrownEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::ArchiveEvents::ChangedParams>,
     .payload = suture::codec::messageOf<wire::ArchiveEvents::ChangedParams, OpenSlot,
                                         encodeArchiveChangedEvent, decodeArchiveChangedEvent>},
};

}  // namespace

const suture::codec::Codec& archiveCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Archive>,
      .contract = capnp::typeId<wire::Archive>(),
      .subscriber = capnp::typeId<wire::ArchiveEvents>(),
      .commands = kArchiveCommandCodecs,
      .events = kArchiveEventCodecs,
      .row = suture::codec::rowOf<wire::ArchiveEvents::StateParams, wire::ArchiveStateRow,
                                  encodeArchiveColumn, decodeArchiveColumn>,
  };
  return kCodec;
}

}  // namespace shapes

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const shapes::Root& value) {
  return codec::encodeAs<shapes::wire::Root, shapes::RootSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Root& value) {
  return codec::decodeAs<shapes::wire::Root, shapes::RootSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Branch& value) {
  return codec::encodeAs<shapes::wire::Branch, shapes::BranchSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Branch& value) {
  return codec::decodeAs<shapes::wire::Branch, shapes::BranchSlot>(bytes, value);
}

template <>
Result<std::vector<std::byte>> encode(const shapes::Open& value) {
  return codec::encodeAs<shapes::wire::Open, shapes::OpenSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, shapes::Open& value) {
  return codec::decodeAs<shapes::wire::Open, shapes::OpenSlot>(bytes, value);
}

}  // namespace suture
