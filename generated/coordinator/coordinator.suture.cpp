// Written by suturec from coordinator/coordinator.h. Do not edit.
#include "coordinator/coordinator.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "coordinator/coordinator.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(CoordinatorParameters::period), std::chrono::nanoseconds>);

}  // namespace

bool store(const CoordinatorParameters& value, CoordinatorParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  return fits;
}

void load(const CoordinatorParametersSlot& slot, CoordinatorParameters& value) {
  load(slot.period, value.period);
}

// --- between slots and Cap'n Proto

void toWire(const CoordinatorParametersSlot& slot, wire::CoordinatorParameters::Builder out) {
  out.setPeriod(slot.period);
}

suture::Errc fromWire(wire::CoordinatorParameters::Reader in, CoordinatorParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  return suture::Errc{};
}

bool isValid(const CoordinatorParametersSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, CoordinatorParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::CoordinatorParameters& value) {
  return rpc::encodeAs<robots::wire::CoordinatorParameters,
                       robots::CoordinatorParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::CoordinatorParameters& value) {
  return rpc::decodeAs<robots::wire::CoordinatorParameters,
                       robots::CoordinatorParametersSlot>(bytes, value);
}

template <>
ComponentClass componentClass<robots::Coordinator>() {
  return {"Coordinator", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::CoordinatorParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::Coordinator(values));
          }};
}

}  // namespace suture
