// Written by suturec from unit/contracts/share.h. Do not edit.
#include <suture/codec/codec.h>
#include <suture/codec/wire.h>

#include "unit/contracts/share.capnp.h"
#include "unit/contracts/share.suture.h"

namespace contracts {

using suture::codec::fromWire;
using suture::codec::toWire;

// --- Share as Cap'n Proto

namespace {

void encodeShareShareResult(const double& slot, wire::Share::ShareResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeShareShareResult(wire::Share::ShareResults::Reader in, double& slot,
                                    suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeShareShares(const ShareSharesArguments& slot, wire::Share::SharesParams::Builder out) {
  out.setAll(slot.all != 0);
}
suture::Errc decodeShareShares(wire::Share::SharesParams::Reader in, ShareSharesArguments& slot,
                               suture::Duration) {
  slot.all = in.getAll();
  return suture::Errc{};
}

void encodeShareSharesResult(const std::int32_t& slot, wire::Share::SharesResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeShareSharesResult(wire::Share::SharesResults::Reader in, std::int32_t& slot,
                                     suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeShareTake(const ShareTakeArguments& slot, wire::Share::TakeParams::Builder out) {
  out.setWanted(slot.wanted);
}
suture::Errc decodeShareTake(wire::Share::TakeParams::Reader in, ShareTakeArguments& slot,
                             suture::Duration) {
  slot.wanted = in.getWanted();
  return suture::Errc{};
}

void encodeShareTakeResult(const double& slot, wire::Share::TakeResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeShareTakeResult(wire::Share::TakeResults::Reader in, double& slot,
                                   suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeShareReachResult(const double& slot, wire::Share::ReachResults::Builder out) {
  out.setValue(slot);
}
suture::Errc decodeShareReachResult(wire::Share::ReachResults::Reader in, double& slot,
                                    suture::Duration) {
  slot = in.getValue();
  return suture::Errc{};
}

void encodeShareShareColumn(const double& slot, wire::ShareStateRow::Builder out) {
  out.setShare(slot);
}
suture::Errc decodeShareShareColumn(wire::ShareStateRow::Reader in, double& slot,
                                    suture::Duration) {
  slot = in.getShare();
  return suture::Errc{};
}

void encodeShareReachColumn(const double& slot, wire::ShareStateRow::Builder out) {
  out.setReach(slot);
}
suture::Errc decodeShareReachColumn(wire::ShareStateRow::Reader in, double& slot,
                                    suture::Duration) {
  slot = in.getReach();
  return suture::Errc{};
}

// A row of the state has a member for each column, so one function each way finds them all.
void encodeShareColumn(unsigned column, const std::byte* memory, wire::ShareStateRow::Builder out) {
  switch (column) {
    case ShareColumn::share: return encodeShareShareColumn(suture::slotIn<double>(memory), out);
    case ShareColumn::reach: return encodeShareReachColumn(suture::slotIn<double>(memory), out);
  }
}
suture::Errc decodeShareColumn(wire::ShareStateRow::Reader in, unsigned column, std::byte* memory,
                               suture::Duration shift) {
  switch (column) {
    case ShareColumn::share:
      return decodeShareShareColumn(in, suture::newSlot<double>(memory), shift);
    case ShareColumn::reach:
      return decodeShareReachColumn(in, suture::newSlot<double>(memory), shift);
  }
  return suture::Errc::Invalid;
}

constexpr suture::codec::CommandCodec kShareCommandCodecs[] = {
    {.interface = capnp::typeId<wire::Share>(),
     .method = 1,
     .sent = suture::codec::sentIn<wire::Share::ShareParams>,
     .result = suture::codec::messageOf<wire::Share::ShareResults, double, encodeShareShareResult,
                                        decodeShareShareResult>,
     .stamp = suture::codec::stampIn<wire::Share::ShareResults>},
    {.interface = capnp::typeId<wire::Share>(),
     .method = 2,
     .sent = suture::codec::sentIn<wire::Share::SharesParams>,
     .arguments = suture::codec::messageOf<wire::Share::SharesParams, ShareSharesArguments,
                                           encodeShareShares, decodeShareShares>,
     .result = suture::codec::messageOf<wire::Share::SharesResults, std::int32_t,
                                        encodeShareSharesResult, decodeShareSharesResult>},
    {.interface = capnp::typeId<wire::Share>(),
     .method = 3,
     .sent = suture::codec::sentIn<wire::Share::TakeParams>,
     .arguments = suture::codec::messageOf<wire::Share::TakeParams, ShareTakeArguments,
                                           encodeShareTake, decodeShareTake>,
     .result = suture::codec::messageOf<wire::Share::TakeResults, double, encodeShareTakeResult,
                                        decodeShareTakeResult>},
    {.interface = capnp::typeId<wire::Share>(),
     .method = 4,
     .sent = suture::codec::sentIn<wire::Share::ReachParams>,
     .result = suture::codec::messageOf<wire::Share::ReachResults, double, encodeShareReachResult,
                                        decodeShareReachResult>,
     .stamp = suture::codec::stampIn<wire::Share::ReachResults>},
};

}  // namespace

const suture::codec::Codec& shareCodec() {
  static constexpr suture::codec::Codec kCodec{
      .schema = suture::codec::schemaOf<wire::Share>,
      .contract = capnp::typeId<wire::Share>(),
      .subscriber = capnp::typeId<wire::ShareEvents>(),
      .commands = kShareCommandCodecs,
      .events = {},
      .row = suture::codec::rowOf<wire::ShareEvents::StateParams, wire::ShareStateRow,
                                  encodeShareColumn, decodeShareColumn>,
  };
  return kCodec;
}

}  // namespace contracts
