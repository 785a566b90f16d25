// Written by suturec from person/axis_range.h. Do not edit.
#include "person/axis_range.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "person/axis_range.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(AxisRange::lowest), std::int32_t>);
static_assert(std::is_same_v<decltype(AxisRange::highest), std::int32_t>);

}  // namespace

bool store(const AxisRange& value, AxisRangeSlot& slot) {
  bool fits = true;
  fits &= store(value.lowest, slot.lowest);
  fits &= store(value.highest, slot.highest);
  return fits;
}

void load(const AxisRangeSlot& slot, AxisRange& value) {
  load(slot.lowest, value.lowest);
  load(slot.highest, value.highest);
}

// --- between slots and Cap'n Proto

void toWire(const AxisRangeSlot& slot, wire::AxisRange::Builder out) {
  out.setLowest(slot.lowest);
  out.setHighest(slot.highest);
}

suture::Errc fromWire(wire::AxisRange::Reader in, AxisRangeSlot& slot, suture::Duration) {
  slot.lowest = in.getLowest();
  slot.highest = in.getHighest();
  return suture::Errc{};
}

bool isValid(const AxisRangeSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, AxisRange& value) {
  suture::JsonReader reader = in;
  reader.field("lowest", value.lowest);
  reader.field("highest", value.highest);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::AxisRange& value) {
  return rpc::encodeAs<robots::wire::AxisRange, robots::AxisRangeSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::AxisRange& value) {
  return rpc::decodeAs<robots::wire::AxisRange, robots::AxisRangeSlot>(bytes, value);
}

}  // namespace suture
