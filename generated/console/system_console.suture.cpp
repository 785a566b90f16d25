// Written by suturec from console/system_console.h. Do not edit.
#include "console/system_console.suture.h"

#include <suture/base/slots/slots.h>
#include <suture/base/slots/valid_values.h>
#include <suture/component/factory/json_reader.h>
#include <suture/codec/stamps.h>

#include <type_traits>

namespace robots {

using suture::isValid;
using suture::load;
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
