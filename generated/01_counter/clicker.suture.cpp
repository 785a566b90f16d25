// Written by suturec from 01_counter/clicker.h. Do not edit.
#include "01_counter/clicker.suture.h"

#include <suture/component/factory/json_reader.h>

#include <type_traits>

namespace suture {

template <>
ComponentClass componentClass<counting::Clicker>() {
  return {"Clicker", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            JsonReader none = parameters;
            none.finish();
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new counting::Clicker());
          }};
}

}  // namespace suture
