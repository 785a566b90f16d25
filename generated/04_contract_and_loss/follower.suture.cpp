// Written by suturec from 04_contract_and_loss/follower.h. Do not edit.
#include "04_contract_and_loss/follower.suture.h"

#include <suture/component/factory/json_reader.h>

#include <type_traits>

namespace suture {

template <>
ComponentClass componentClass<following::Follower>() {
  return {"Follower", [](const JsonReader& parameters) -> std::unique_ptr<Component> {
            JsonReader none = parameters;
            none.finish();
            if (parameters.failed()) return nullptr;
            return std::unique_ptr<Component>(new following::Follower());
          }};
}

}  // namespace suture
