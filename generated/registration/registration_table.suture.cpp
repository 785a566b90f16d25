// Written by suturec from registration/registration_table.h. Do not edit.
#include "registration/registration_table.suture.h"

#include <suture/component/json_reader.h>

#include <type_traits>

// Defined in registration/registration.suture.cpp.
namespace robots {
void fromJson(const suture::JsonReader& in, SceneFrames& value);
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
