// Written by suturec from 01_counter/tally.h. Do not edit.
#include "01_counter/tally.suture.h"

#include <suture/component/factory/json_reader.h>

#include <type_traits>

namespace suture {

template <>
ComponentClass componentClass<counting::Tally>() {
  return {"Tally", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            JsonReader none = parameters;
            none.finish();
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new counting::Tally());
          }};
}

}  // namespace suture
