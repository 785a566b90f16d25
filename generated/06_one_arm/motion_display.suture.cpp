// Written by suturec from 06_one_arm/motion_display.h. Do not edit.
#include "06_one_arm/motion_display.suture.h"

#include <suture/component/factory/json_reader.h>

#include <type_traits>

namespace suture {

template <>
ComponentClass componentClass<watching::MotionDisplay>() {
  return {"MotionDisplay", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            JsonReader none = parameters;
            none.finish();
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new watching::MotionDisplay());
          }};
}

}  // namespace suture
