// Written by suturec from 03_own_data_type/display.h. Do not edit.
#include "03_own_data_type/display.suture.h"

#include <suture/component/factory/json_reader.h>

#include <type_traits>

namespace suture {

template <>
ComponentClass componentClass<tracking::Display>() {
  return {"Display", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            JsonReader none = parameters;
            none.finish();
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new tracking::Display());
          }};
}

}  // namespace suture
