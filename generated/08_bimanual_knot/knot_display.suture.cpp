// Written by suturec from 08_bimanual_knot/knot_display.h. Do not edit.
#include "08_bimanual_knot/knot_display.suture.h"

#include <suture/component/factory/json_reader.h>

#include <type_traits>

namespace suture {

template <>
ComponentClass componentClass<watching::KnotDisplay>() {
  return {"KnotDisplay", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            JsonReader none = parameters;
            none.finish();
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new watching::KnotDisplay());
          }};
}

}  // namespace suture
