// Written by suturec from registration/registration_table.h. Do not edit.
#include "registration/registration_table.suture.h"

#include <suture/component/factory/json_reader.h>

#include <type_traits>

namespace robots {

inline void fromJson(const suture::JsonReader& in, SceneFrames& value) {
  suture::JsonReader reader = in;
  reader.field("left_base", value.left_base);
  reader.field("right_base", value.right_base);
  reader.field("camera", value.camera);
  reader.field("tissue", value.tissue);
  reader.field("left_master", value.left_master);
  reader.field("right_master", value.right_master);
  reader.field("display", value.display);
  reader.finish();
}

}  // namespace robots

namespace suture {

template <>
ComponentClass componentClass<robots::RegistrationTable>() {
  return {"RegistrationTable", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            robots::SceneFrames values;
            fromJson(parameters, values);
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new robots::RegistrationTable(values));
          }};
}

}  // namespace suture
