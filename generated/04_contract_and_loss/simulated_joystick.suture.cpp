// Written by suturec from 04_contract_and_loss/simulated_joystick.h. Do not edit.
#include "04_contract_and_loss/simulated_joystick.suture.h"

#include <suture/component/factory/json_reader.h>

#include <type_traits>

namespace suture {

template <>
ComponentClass componentClass<following::SimulatedJoystick>() {
  return {"SimulatedJoystick", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            JsonReader none = parameters;
            none.finish();
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new following::SimulatedJoystick());
          }};
}

}  // namespace suture
