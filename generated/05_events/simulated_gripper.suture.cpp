// Written by suturec from 05_events/simulated_gripper.h. Do not edit.
#include "05_events/simulated_gripper.suture.h"

#include <suture/component/factory/json_reader.h>

#include <type_traits>

namespace suture {

template <>
ComponentClass componentClass<gripping::SimulatedGripper>() {
  return {"SimulatedGripper", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            JsonReader none = parameters;
            none.finish();
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new gripping::SimulatedGripper());
          }};
}

}  // namespace suture
