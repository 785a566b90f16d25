// Written by suturec from shapes/guest.h. Do not edit.
#include "shapes/guest.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "shapes/guest.capnp.h"

namespace shapes {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(guest::Limits::low), double>);
static_assert(std::is_same_v<decltype(guest::Limits::high), double>);

}  // namespace

bool store(const guest::Limits& value, guestLimitsSlot& slot) {
  bool fits = true;
  fits &= store(value.low, slot.low);
  fits &= store(value.high, slot.high);
  return fits;
}

void load(const guestLimitsSlot& slot, guest::Limits& value) {
  load(slot.low, value.low);
  load(slot.high, value.high);
}

// --- between slots and Cap'n Proto

void toWire(const guestLimitsSlot& slot, wire::Limits::Builder out) {
  out.setLow(slot.low);
  out.setHigh(slot.high);
}

suture::Errc fromWire(wire::Limits::Reader in, guestLimitsSlot& slot, suture::Duration) {
  slot.low = in.getLow();
  slot.high = in.getHigh();
  return suture::Errc{};
}

bool isValid(const guestLimitsSlot& slot, suture::FieldPath* path) {
  if (!isValid(slot.low)) return suture::refusedAt(path, "low");
  return isValid(slot.high) || suture::refusedAt(path, "high");
}

}  // namespace shapes

namespace guest {

void fromJson(const suture::JsonReader& in, Limits& value) {
  suture::JsonReader reader = in;
  reader.field("low", value.low);
  reader.field("high", value.high);
  reader.finish();
}

}  // namespace guest

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const guest::Limits& value) {
  return rpc::encodeAs<shapes::wire::Limits, shapes::guestLimitsSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, guest::Limits& value) {
  return rpc::decodeAs<shapes::wire::Limits, shapes::guestLimitsSlot>(bytes, value);
}

template <>
ComponentClass componentClass<shapes::Fence>() {
  return {"Fence", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            guest::Limits values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new shapes::Fence(values));
          }};
}

}  // namespace suture
