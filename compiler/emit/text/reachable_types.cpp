#include "compiler/emit/text/reachable_types.h"

namespace suture::compiler::emit {

void Reached::add(const model::Type& type) {
  for (const model::Type& element : type.element) add(element);
  if (!type.name.empty()) add(type.name);
}

void Reached::add(const std::string& name) {
  if (!seen_.insert(name).second) return;
  if (const model::Enum* const one = lookup_.findEnum(name)) enums_.push_back(one);
  const model::Struct* const one = lookup_.findStruct(name);
  if (!one) return;
  for (const model::Field& field : one->fields) add(field.type);
  structs_.push_back(one);
}

void Reached::add(const model::Interface& interface) {
  for (const model::Command& command : interface.commands) {
    for (const model::Parameter& parameter : command.parameters) add(parameter.type);
    if (command.result) add(*command.result);
  }
  for (const model::Event& event : interface.events) {
    for (const model::Type& type : event.payload) add(type);
  }
}

}  // namespace suture::compiler::emit
