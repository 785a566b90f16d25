// Written by suturec from pedals/scripted_pedals.h. Do not edit.
#include "pedals/scripted_pedals.suture.h"

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
static_assert(std::is_same_v<decltype(ScriptedPedalsParameters::period), std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(ScriptedPedalsParameters::clutch_after),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(ScriptedPedalsParameters::clutch_for),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(ScriptedPedalsParameters::leave_after),
                             std::chrono::nanoseconds>);
static_assert(std::is_same_v<decltype(ScriptedPedalsParameters::leave_for),
                             std::chrono::nanoseconds>);

}  // namespace

bool store(const ScriptedPedalsParameters& value, ScriptedPedalsParametersSlot& slot) {
  bool fits = true;
  fits &= store(value.period, slot.period);
  fits &= store(value.clutch_after, slot.clutch_after);
  fits &= store(value.clutch_for, slot.clutch_for);
  fits &= store(value.leave_after, slot.leave_after);
  fits &= store(value.leave_for, slot.leave_for);
  return fits;
}

void load(const ScriptedPedalsParametersSlot& slot, ScriptedPedalsParameters& value) {
  load(slot.period, value.period);
  load(slot.clutch_after, value.clutch_after);
  load(slot.clutch_for, value.clutch_for);
  load(slot.leave_after, value.leave_after);
  load(slot.leave_for, value.leave_for);
}

bool isValid(const ScriptedPedalsParametersSlot&, suture::FieldPath*) {
  return true;
}

}  // namespace robots

namespace robots {

void fromJson(const suture::JsonReader& in, ScriptedPedalsParameters& value) {
  suture::JsonReader reader = in;
  reader.field("period", value.period);
  reader.field("clutch_after", value.clutch_after);
  reader.field("clutch_for", value.clutch_for);
  reader.field("leave_after", value.leave_after);
  reader.field("leave_for", value.leave_for);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::ScriptedPedals>() {
  return {"ScriptedPedals", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::ScriptedPedalsParameters values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::ScriptedPedals(values));
          }};
}

}  // namespace suture
