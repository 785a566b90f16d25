// Written by suturec from console/system_console.h. Do not edit.
#include "console/system_console.suture.h"

#include <suture/component/factory/json_reader.h>
#include <suture/wire/flat.h>
#include <suture/wire/wire.h>

#include <type_traits>

#include "console/system_console.capnp.h"

namespace robots {

using suture::load;
using suture::rpc::fromWire;
using suture::rpc::isValid;
using suture::rpc::toWire;
using suture::store;

namespace {

// What this compiler sees must be what suturec read.
static_assert(std::is_same_v<decltype(SystemConsoleParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(SystemConsoleParameters::system), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(SystemConsoleParameters::patience),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(SystemConsoleParameters::bring_up_by_itself), bool>);

}  // namespace

bool store(const SystemConsoleParameters& value, SystemConsoleParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.system, slot.system);
  fits &= store(value.patience, slot.patience);
  fits &= store(value.bring_up_by_itself, slot.bring_up_by_itself);
  return fits;
}

void load(const SystemConsoleParametersSlot& slot, SystemConsoleParameters& value) {
  load(slot.period, value.period);
  load(slot.system, value.system);
  load(slot.patience, value.patience);
  load(slot.bring_up_by_itself, value.bring_up_by_itself);
}

void reserve(const SystemConsoleParametersSlot*, SystemConsoleParameters& value) {
  suture::reserveFor<decltype(SystemConsoleParametersSlot::system)>(value.system);
}

// --- between slots and Cap'n Proto

void toWire(const SystemConsoleParametersSlot& slot, wire::SystemConsoleParameters::Builder out) {
  out.setPeriod(slot.period);
  toWire(slot.system, out.initSystem(sizeOf(slot.system)));
  out.setPatience(slot.patience);
  out.setBringUpByItself(slot.bring_up_by_itself != 0);
}

suture::Errc fromWire(wire::SystemConsoleParameters::Reader in, SystemConsoleParametersSlot& slot,
                      suture::Duration) {
  slot.period = in.getPeriod();
  slot.patience = in.getPatience();
  slot.bring_up_by_itself = in.getBringUpByItself();
  return fromWire(in.getSystem(), slot.system);
}

bool isValid(const SystemConsoleParametersSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, SystemConsoleParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("system", value.system);
  reader.field("patience", value.patience);
  reader.field("bring_up_by_itself", value.bring_up_by_itself);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
Result<std::vector<std::byte>> encode(const robots::SystemConsoleParameters& value) {
  return rpc::encodeAs<robots::wire::SystemConsoleParameters,
                       robots::SystemConsoleParametersSlot>(value);
}

template <>
Result<> decode(std::span<const std::byte> bytes, robots::SystemConsoleParameters& value) {
  return rpc::decodeAs<robots::wire::SystemConsoleParameters,
                       robots::SystemConsoleParametersSlot>(bytes, value);
}

template <>
ComponentClass componentClass<robots::SystemConsole>() {
  return {"SystemConsole", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::SystemConsoleParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            std::unique_ptr<Component> component(new robots::SystemConsole(values));
            makeOptional(*component, {"MTML", "MTMR", "PSM1", "PSM2", "TeleopL", "TeleopR", "Guide"});
            return component;
          }};
}

}  // namespace suture
