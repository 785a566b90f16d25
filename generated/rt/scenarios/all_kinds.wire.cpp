// Written by suturec from rt/scenarios/all_kinds.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "rt/scenarios/all_kinds.capnp.h"
#include "rt/scenarios/all_kinds.suture.h"

// Defined in robot_types/pose.wire.cpp.
namespace robots {
void toWire(const PosePrmSlot& slot, wire::PosePrm::Builder out);
suture::Errc fromWire(wire::PosePrm::Reader in, PosePrmSlot& slot, suture::Duration shift);
}  // namespace robots

namespace scenarios {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- AllKinds as Cap'n Proto

namespace {

void encodeAllKindsSetScalar(const AllKindsSetScalarArguments& slot,
                             wire::AllKinds::SetScalarParams::Builder out) {
  out.setValue(slot.value);
}
suture::Errc decodeAllKindsSetScalar(wire::AllKinds::SetScalarParams::Reader in,
                                     AllKindsSetScalarArguments& slot, suture::Duration) {
  slot.value = in.getValue();
  return suture::Errc{};
}

void encodeAllKindsSetVector(const AllKindsSetVectorArguments& slot,
                             wire::AllKinds::SetVectorParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeAllKindsSetVector(wire::AllKinds::SetVectorParams::Reader in,
                                     AllKindsSetVectorArguments& slot, suture::Duration) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value) : suture::Errc::Invalid;
}

void encodeAllKindsSetRecord(const AllKindsSetRecordArguments& slot,
                             wire::AllKinds::SetRecordParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeAllKindsSetRecord(wire::AllKinds::SetRecordParams::Reader in,
                                     AllKindsSetRecordArguments& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeAllKindsSetText(const AllKindsSetTextArguments& slot,
                           wire::AllKinds::SetTextParams::Builder out) {
  toWire(slot.value, out.initValue(sizeOf(slot.value)));
}
suture::Errc decodeAllKindsSetText(wire::AllKinds::SetTextParams::Reader in,
                                   AllKindsSetTextArguments& slot, suture::Duration) {
  return fromWire(in.getValue(), slot.value);
}

void encodeAllKindsScalarResult(const double& slot, wire::AllKinds::ScalarResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeAllKindsScalarResult(wire::AllKinds::ScalarResults::Reader in, double& slot,
                                        suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeAllKindsVectorResult(const std::array<double, 3>& slot,
                                wire::AllKinds::VectorResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeAllKindsVectorResult(wire::AllKinds::VectorResults::Reader in,
                                        std::array<double, 3>& slot, suture::Duration) {
  return in.hasValue() ? fromWire(in.getValue(), slot) : suture::Errc::Invalid;
}

void encodeAllKindsRecordResult(const robots::PosePrmSlot& slot,
                                wire::AllKinds::RecordResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeAllKindsRecordResult(wire::AllKinds::RecordResults::Reader in,
                                        robots::PosePrmSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeAllKindsTextResult(const suture::BoundedText<31>& slot,
                              wire::AllKinds::TextResults::Builder out) {
  toWire(slot, out.initValue(sizeOf(slot)));
}
suture::Errc decodeAllKindsTextResult(wire::AllKinds::TextResults::Reader in,
                                      suture::BoundedText<31>& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeAllKindsTwiceScalar(const AllKindsTwiceScalarArguments& slot,
                               wire::AllKinds::TwiceScalarParams::Builder out) {
  out.setValue(slot.value);
}
suture::Errc decodeAllKindsTwiceScalar(wire::AllKinds::TwiceScalarParams::Reader in,
                                       AllKindsTwiceScalarArguments& slot, suture::Duration) {
  slot.value = in.getValue();
  return suture::Errc{};
}

void encodeAllKindsTwiceScalarResult(const double& slot,
                                     wire::AllKinds::TwiceScalarResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeAllKindsTwiceScalarResult(wire::AllKinds::TwiceScalarResults::Reader in,
                                             double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeAllKindsTwiceVector(const AllKindsTwiceVectorArguments& slot,
                               wire::AllKinds::TwiceVectorParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeAllKindsTwiceVector(wire::AllKinds::TwiceVectorParams::Reader in,
                                       AllKindsTwiceVectorArguments& slot, suture::Duration) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value) : suture::Errc::Invalid;
}

void encodeAllKindsTwiceVectorResult(const std::array<double, 3>& slot,
                                     wire::AllKinds::TwiceVectorResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeAllKindsTwiceVectorResult(wire::AllKinds::TwiceVectorResults::Reader in,
                                             std::array<double, 3>& slot, suture::Duration) {
  return in.hasValue() ? fromWire(in.getValue(), slot) : suture::Errc::Invalid;
}

void encodeAllKindsTwiceRecord(const AllKindsTwiceRecordArguments& slot,
                               wire::AllKinds::TwiceRecordParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeAllKindsTwiceRecord(wire::AllKinds::TwiceRecordParams::Reader in,
                                       AllKindsTwiceRecordArguments& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeAllKindsTwiceRecordResult(const robots::PosePrmSlot& slot,
                                     wire::AllKinds::TwiceRecordResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeAllKindsTwiceRecordResult(wire::AllKinds::TwiceRecordResults::Reader in,
                                             robots::PosePrmSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeAllKindsTwiceText(const AllKindsTwiceTextArguments& slot,
                             wire::AllKinds::TwiceTextParams::Builder out) {
  toWire(slot.value, out.initValue(sizeOf(slot.value)));
}
suture::Errc decodeAllKindsTwiceText(wire::AllKinds::TwiceTextParams::Reader in,
                                     AllKindsTwiceTextArguments& slot, suture::Duration) {
  return fromWire(in.getValue(), slot.value);
}

void encodeAllKindsTwiceTextResult(const suture::BoundedText<31>& slot,
                                   wire::AllKinds::TwiceTextResults::Builder out) {
  toWire(slot, out.initValue(sizeOf(slot)));
}
suture::Errc decodeAllKindsTwiceTextResult(wire::AllKinds::TwiceTextResults::Reader in,
                                           suture::BoundedText<31>& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeAllKindsTakeScalarResult(const double& slot,
                                    wire::AllKinds::TakeScalarResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeAllKindsTakeScalarResult(wire::AllKinds::TakeScalarResults::Reader in,
                                            double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeAllKindsTakeVectorResult(const std::array<double, 3>& slot,
                                    wire::AllKinds::TakeVectorResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeAllKindsTakeVectorResult(wire::AllKinds::TakeVectorResults::Reader in,
                                            std::array<double, 3>& slot, suture::Duration) {
  return in.hasValue() ? fromWire(in.getValue(), slot) : suture::Errc::Invalid;
}

void encodeAllKindsTakeRecordResult(const robots::PosePrmSlot& slot,
                                    wire::AllKinds::TakeRecordResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeAllKindsTakeRecordResult(wire::AllKinds::TakeRecordResults::Reader in,
                                            robots::PosePrmSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeAllKindsTakeTextResult(const suture::BoundedText<31>& slot,
                                  wire::AllKinds::TakeTextResults::Builder out) {
  toWire(slot, out.initValue(sizeOf(slot)));
}
suture::Errc decodeAllKindsTakeTextResult(wire::AllKinds::TakeTextResults::Reader in,
                                          suture::BoundedText<31>& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeAllKindsSwapScalar(const AllKindsSwapScalarArguments& slot,
                              wire::AllKinds::SwapScalarParams::Builder out) {
  out.setValue(slot.value);
}
suture::Errc decodeAllKindsSwapScalar(wire::AllKinds::SwapScalarParams::Reader in,
                                      AllKindsSwapScalarArguments& slot, suture::Duration) {
  slot.value = in.getValue();
  return suture::Errc{};
}

void encodeAllKindsSwapScalarResult(const double& slot,
                                    wire::AllKinds::SwapScalarResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeAllKindsSwapScalarResult(wire::AllKinds::SwapScalarResults::Reader in,
                                            double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeAllKindsSwapVector(const AllKindsSwapVectorArguments& slot,
                              wire::AllKinds::SwapVectorParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeAllKindsSwapVector(wire::AllKinds::SwapVectorParams::Reader in,
                                      AllKindsSwapVectorArguments& slot, suture::Duration) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value) : suture::Errc::Invalid;
}

void encodeAllKindsSwapVectorResult(const std::array<double, 3>& slot,
                                    wire::AllKinds::SwapVectorResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeAllKindsSwapVectorResult(wire::AllKinds::SwapVectorResults::Reader in,
                                            std::array<double, 3>& slot, suture::Duration) {
  return in.hasValue() ? fromWire(in.getValue(), slot) : suture::Errc::Invalid;
}

void encodeAllKindsSwapRecord(const AllKindsSwapRecordArguments& slot,
                              wire::AllKinds::SwapRecordParams::Builder out) {
  toWire(slot.value, out.initValue());
}
suture::Errc decodeAllKindsSwapRecord(wire::AllKinds::SwapRecordParams::Reader in,
                                      AllKindsSwapRecordArguments& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot.value, shift) : suture::Errc::Invalid;
}

void encodeAllKindsSwapRecordResult(const robots::PosePrmSlot& slot,
                                    wire::AllKinds::SwapRecordResults::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeAllKindsSwapRecordResult(wire::AllKinds::SwapRecordResults::Reader in,
                                            robots::PosePrmSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeAllKindsSwapText(const AllKindsSwapTextArguments& slot,
                            wire::AllKinds::SwapTextParams::Builder out) {
  toWire(slot.value, out.initValue(sizeOf(slot.value)));
}
suture::Errc decodeAllKindsSwapText(wire::AllKinds::SwapTextParams::Reader in,
                                    AllKindsSwapTextArguments& slot, suture::Duration) {
  return fromWire(in.getValue(), slot.value);
}

void encodeAllKindsSwapTextResult(const suture::BoundedText<31>& slot,
                                  wire::AllKinds::SwapTextResults::Builder out) {
  toWire(slot, out.initValue(sizeOf(slot)));
}
suture::Errc decodeAllKindsSwapTextResult(wire::AllKinds::SwapTextResults::Reader in,
                                          suture::BoundedText<31>& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeAllKindsScalarSetEvent(const double& slot,
                                  wire::AllKindsEvents::ScalarSetParams::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeAllKindsScalarSetEvent(wire::AllKindsEvents::ScalarSetParams::Reader in,
                                          double& slot, suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeAllKindsVectorSetEvent(const std::array<double, 3>& slot,
                                  wire::AllKindsEvents::VectorSetParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeAllKindsVectorSetEvent(wire::AllKindsEvents::VectorSetParams::Reader in,
                                          std::array<double, 3>& slot, suture::Duration) {
  return in.hasValue() ? fromWire(in.getValue(), slot) : suture::Errc::Invalid;
}

void encodeAllKindsRecordSetEvent(const robots::PosePrmSlot& slot,
                                  wire::AllKindsEvents::RecordSetParams::Builder out) {
  toWire(slot, out.initValue());
}
suture::Errc decodeAllKindsRecordSetEvent(wire::AllKindsEvents::RecordSetParams::Reader in,
                                          robots::PosePrmSlot& slot, suture::Duration shift) {
  return in.hasValue() ? fromWire(in.getValue(), slot, shift) : suture::Errc::Invalid;
}

void encodeAllKindsTextSetEvent(const suture::BoundedText<31>& slot,
                                wire::AllKindsEvents::TextSetParams::Builder out) {
  toWire(slot, out.initValue(sizeOf(slot)));
}
suture::Errc decodeAllKindsTextSetEvent(wire::AllKindsEvents::TextSetParams::Reader in,
                                        suture::BoundedText<31>& slot, suture::Duration) {
  return fromWire(in.getValue(), slot);
}

void encodeAllKindsScalarColumn(const double& slot, wire::AllKindsStateRow::Builder out) {
  out.setScalar(slot);
}
suture::Errc decodeAllKindsScalarColumn(wire::AllKindsStateRow::Reader in, double& slot,
                                        suture::Duration) {
  slot = in.getScalar();
  return suture::Errc{};
}

void encodeAllKindsVectorColumn(const std::array<double, 3>& slot,
                                wire::AllKindsStateRow::Builder out) {
  toWire(slot, out.initVector());
}
suture::Errc decodeAllKindsVectorColumn(wire::AllKindsStateRow::Reader in,
                                        std::array<double, 3>& slot, suture::Duration) {
  return in.hasVector() ? fromWire(in.getVector(), slot) : suture::Errc::Invalid;
}

void encodeAllKindsRecordColumn(const robots::PosePrmSlot& slot,
                                wire::AllKindsStateRow::Builder out) {
  toWire(slot, out.initRecord());
}
suture::Errc decodeAllKindsRecordColumn(wire::AllKindsStateRow::Reader in,
                                        robots::PosePrmSlot& slot, suture::Duration shift) {
  return in.hasRecord() ? fromWire(in.getRecord(), slot, shift) : suture::Errc::Invalid;
}

void encodeAllKindsTextColumn(const suture::BoundedText<31>& slot,
                              wire::AllKindsStateRow::Builder out) {
  toWire(slot, out.initText(sizeOf(slot)));
}
suture::Errc decodeAllKindsTextColumn(wire::AllKindsStateRow::Reader in,
                                      suture::BoundedText<31>& slot, suture::Duration) {
  return fromWire(in.getText(), slot);
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeAllKindsColumn(unsigned column, const std::byte* memory,
                          wire::AllKindsStateRow::Builder out) {
  switch (column) {
    case AllKindsColumn::scalar:
      return encodeAllKindsScalarColumn(suture::slotIn<double>(memory), out);
    case AllKindsColumn::vector:
      return encodeAllKindsVectorColumn(suture::slotIn<std::array<double, 3>>(memory), out);
    case AllKindsColumn::record:
      return encodeAllKindsRecordColumn(suture::slotIn<robots::PosePrmSlot>(memory), out);
    case AllKindsColumn::text:
      return encodeAllKindsTextColumn(suture::slotIn<suture::BoundedText<31>>(memory), out);
  }
}
suture::Errc decodeAllKindsColumn(wire::AllKindsStateRow::Reader in, unsigned column,
                                  std::byte* memory, suture::Duration shift) {
  switch (column) {
    case AllKindsColumn::scalar:
      return decodeAllKindsScalarColumn(in, suture::newSlot<double>(memory), shift);
    case AllKindsColumn::vector:
      return decodeAllKindsVectorColumn(in, suture::newSlot<std::array<double, 3>>(memory), shift);
    case AllKindsColumn::record:
      return decodeAllKindsRecordColumn(in, suture::newSlot<robots::PosePrmSlot>(memory), shift);
    case AllKindsColumn::text:
      return decodeAllKindsTextColumn(in, suture::newSlot<suture::BoundedText<31>>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kAllKindsCommandCodecs[] = {
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::AllKinds::ClearParams>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::AllKinds::SetScalarParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::SetScalarParams,
                                           AllKindsSetScalarArguments, encodeAllKindsSetScalar,
                                           decodeAllKindsSetScalar>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::AllKinds::SetVectorParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::SetVectorParams,
                                           AllKindsSetVectorArguments, encodeAllKindsSetVector,
                                           decodeAllKindsSetVector>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::AllKinds::SetRecordParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::SetRecordParams,
                                           AllKindsSetRecordArguments, encodeAllKindsSetRecord,
                                           decodeAllKindsSetRecord>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 5,
     .sent = suture::codec::sentIn<wire::AllKinds::SetTextParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::SetTextParams, AllKindsSetTextArguments,
                                           encodeAllKindsSetText, decodeAllKindsSetText>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 6,
     .sent = suture::codec::sentIn<wire::AllKinds::ScalarParams>,
     .result = suture::codec::messageOf<wire::AllKinds::ScalarResults, double,
                                        encodeAllKindsScalarResult, decodeAllKindsScalarResult>,
     .stamp = suture::codec::stampIn<wire::AllKinds::ScalarResults>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 7,
     .sent = suture::codec::sentIn<wire::AllKinds::VectorParams>,
     .result = suture::codec::messageOf<wire::AllKinds::VectorResults, std::array<double, 3>,
                                        encodeAllKindsVectorResult, decodeAllKindsVectorResult>,
     .stamp = suture::codec::stampIn<wire::AllKinds::VectorResults>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 8,
     .sent = suture::codec::sentIn<wire::AllKinds::RecordParams>,
     .result = suture::codec::messageOf<wire::AllKinds::RecordResults, robots::PosePrmSlot,
                                        encodeAllKindsRecordResult, decodeAllKindsRecordResult>,
     .stamp = suture::codec::stampIn<wire::AllKinds::RecordResults>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 9,
     .sent = suture::codec::sentIn<wire::AllKinds::TextParams>,
     .result = suture::codec::messageOf<wire::AllKinds::TextResults, suture::BoundedText<31>,
                                        encodeAllKindsTextResult, decodeAllKindsTextResult>,
     .stamp = suture::codec::stampIn<wire::AllKinds::TextResults>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 10,
     .sent = suture::codec::sentIn<wire::AllKinds::TwiceScalarParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::TwiceScalarParams,
                                           AllKindsTwiceScalarArguments, encodeAllKindsTwiceScalar,
                                           decodeAllKindsTwiceScalar>,
     .result = suture::codec::messageOf<wire::AllKinds::TwiceScalarResults, double,
                                        encodeAllKindsTwiceScalarResult,
                                        decodeAllKindsTwiceScalarResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 11,
     .sent = suture::codec::sentIn<wire::AllKinds::TwiceVectorParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::TwiceVectorParams,
                                           AllKindsTwiceVectorArguments, encodeAllKindsTwiceVector,
                                           decodeAllKindsTwiceVector>,
     .result = suture::codec::messageOf<wire::AllKinds::TwiceVectorResults, std::array<double, 3>,
                                        encodeAllKindsTwiceVectorResult,
                                        decodeAllKindsTwiceVectorResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 12,
     .sent = suture::codec::sentIn<wire::AllKinds::TwiceRecordParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::TwiceRecordParams,
                                           AllKindsTwiceRecordArguments, encodeAllKindsTwiceRecord,
                                           decodeAllKindsTwiceRecord>,
     .result = suture::codec::messageOf<wire::AllKinds::TwiceRecordResults, robots::PosePrmSlot,
                                        encodeAllKindsTwiceRecordResult,
                                        decodeAllKindsTwiceRecordResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 13,
     .sent = suture::codec::sentIn<wire::AllKinds::TwiceTextParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::TwiceTextParams,
                                           AllKindsTwiceTextArguments, encodeAllKindsTwiceText,
                                           decodeAllKindsTwiceText>,
     .result = suture::codec::messageOf<wire::AllKinds::TwiceTextResults, suture::BoundedText<31>,
                                        encodeAllKindsTwiceTextResult,
                                        decodeAllKindsTwiceTextResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 14,
     .sent = suture::codec::sentIn<wire::AllKinds::TakeScalarParams>,
     .result = suture::codec::messageOf<wire::AllKinds::TakeScalarResults, double,
                                        encodeAllKindsTakeScalarResult,
                                        decodeAllKindsTakeScalarResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 15,
     .sent = suture::codec::sentIn<wire::AllKinds::TakeVectorParams>,
     .result = suture::codec::messageOf<wire::AllKinds::TakeVectorResults, std::array<double, 3>,
                                        encodeAllKindsTakeVectorResult,
                                        decodeAllKindsTakeVectorResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 16,
     .sent = suture::codec::sentIn<wire::AllKinds::TakeRecordParams>,
     .result = suture::codec::messageOf<wire::AllKinds::TakeRecordResults, robots::PosePrmSlot,
                                        encodeAllKindsTakeRecordResult,
                                        decodeAllKindsTakeRecordResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 17,
     .sent = suture::codec::sentIn<wire::AllKinds::TakeTextParams>,
     .result = suture::codec::messageOf<wire::AllKinds::TakeTextResults, suture::BoundedText<31>,
                                        encodeAllKindsTakeTextResult,
                                        decodeAllKindsTakeTextResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 18,
     .sent = suture::codec::sentIn<wire::AllKinds::SwapScalarParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::SwapScalarParams,
                                           AllKindsSwapScalarArguments, encodeAllKindsSwapScalar,
                                           decodeAllKindsSwapScalar>,
     .result = suture::codec::messageOf<wire::AllKinds::SwapScalarResults, double,
                                        encodeAllKindsSwapScalarResult,
                                        decodeAllKindsSwapScalarResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 19,
     .sent = suture::codec::sentIn<wire::AllKinds::SwapVectorParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::SwapVectorParams,
                                           AllKindsSwapVectorArguments, encodeAllKindsSwapVector,
                                           decodeAllKindsSwapVector>,
     .result = suture::codec::messageOf<wire::AllKinds::SwapVectorResults, std::array<double, 3>,
                                        encodeAllKindsSwapVectorResult,
                                        decodeAllKindsSwapVectorResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 20,
     .sent = suture::codec::sentIn<wire::AllKinds::SwapRecordParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::SwapRecordParams,
                                           AllKindsSwapRecordArguments, encodeAllKindsSwapRecord,
                                           decodeAllKindsSwapRecord>,
     .result = suture::codec::messageOf<wire::AllKinds::SwapRecordResults, robots::PosePrmSlot,
                                        encodeAllKindsSwapRecordResult,
                                        decodeAllKindsSwapRecordResult>},
    {.interface = capnp::typeId<wire::AllKinds>(),
     .method = 21,
     .sent = suture::codec::sentIn<wire::AllKinds::SwapTextParams>,
     .arguments = suture::codec::messageOf<wire::AllKinds::SwapTextParams,
                                           AllKindsSwapTextArguments, encodeAllKindsSwapText,
                                           decodeAllKindsSwapText>,
     .result = suture::codec::messageOf<wire::AllKinds::SwapTextResults, suture::BoundedText<31>,
                                        encodeAllKindsSwapTextResult,
                                        decodeAllKindsSwapTextResult>},
};

constexpr suture::codec::EventCodec kAllKindsEventCodecs[] = {
    {.method = 1, .stamp = suture::codec::stampIn<wire::AllKindsEvents::ClearedParams>},
    {.method = 2,
     .stamp = suture::codec::stampIn<wire::AllKindsEvents::ScalarSetParams>,
     .payload = suture::codec::messageOf<wire::AllKindsEvents::ScalarSetParams, double,
                                         encodeAllKindsScalarSetEvent,
                                         decodeAllKindsScalarSetEvent>},
    {.method = 3,
     .stamp = suture::codec::stampIn<wire::AllKindsEvents::VectorSetParams>,
     .payload = suture::codec::messageOf<wire::AllKindsEvents::VectorSetParams,
                                         std::array<double, 3>, encodeAllKindsVectorSetEvent,
                                         decodeAllKindsVectorSetEvent>},
    {.method = 4,
     .stamp = suture::codec::stampIn<wire::AllKindsEvents::RecordSetParams>,
     .payload = suture::codec::messageOf<wire::AllKindsEvents::RecordSetParams, robots::PosePrmSlot,
                                         encodeAllKindsRecordSetEvent,
                                         decodeAllKindsRecordSetEvent>},
    {.method = 5,
     .stamp = suture::codec::stampIn<wire::AllKindsEvents::TextSetParams>,
     .payload = suture::codec::messageOf<wire::AllKindsEvents::TextSetParams,
                                         suture::BoundedText<31>, encodeAllKindsTextSetEvent,
                                         decodeAllKindsTextSetEvent>},
};

}  // namespace

const suture::codec::Codec& allKindsCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::AllKinds>,
      .contract = capnp::typeId<wire::AllKinds>(),
      .subscriber = capnp::typeId<wire::AllKindsEvents>(),
      .commands = kAllKindsCommandCodecs,
      .events = kAllKindsEventCodecs,
      .row = suture::codec::rowOf<wire::AllKindsEvents::StateParams, wire::AllKindsStateRow,
                                  encodeAllKindsColumn, decodeAllKindsColumn>,
  };
  return kCodec;
}

}  // namespace scenarios
