#pragma once
// These are the smallest models that pass every check.

#include <string>
#include <vector>

#include "compiler/check/check.h"
#include "compiler/model/model.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check::samples {

inline model::Type number() {
  model::Type type;
  type.spelling = "double";
  return type;
}

inline model::Type text(std::optional<unsigned> capacity) {
  model::Type type;
  type.shape = model::Type::Shape::Text;
  type.capacity = capacity;
  type.spelling = "std::string";
  return type;
}

inline model::Type list(model::Type element, std::optional<unsigned> capacity) {
  model::Type type;
  type.shape = model::Type::Shape::List;
  type.capacity = capacity;
  type.spelling = "std::vector<" + element.spelling + ">";
  type.element.push_back(std::move(element));
  return type;
}

inline model::Type named(const std::string& name) {
  model::Type type;
  type.shape = model::Type::Shape::Struct;
  type.name = type.spelling = name;
  return type;
}

inline model::Field field(const std::string& name, model::Type type) {
  model::Field result;
  result.name = name;
  result.wireName = model::camelCase(name);
  result.type = std::move(type);
  return result;
}

inline model::Parameter parameter(const std::string& name, model::Type type) {
  model::Parameter result;
  result.name = name;
  result.wireName = model::camelCase(name);
  result.type = std::move(type);
  return result;
}

inline model::Command write(const std::string& name, model::Type type) {
  model::Command command;
  command.name = name;
  command.wireName = model::camelCase(name);
  command.kind = model::CommandKind::Write;
  command.parameters.push_back(parameter("value", std::move(type)));
  return command;
}

inline model::Command read(const std::string& name, model::Type type) {
  model::Command command;
  command.name = name;
  command.wireName = model::camelCase(name);
  command.kind = model::CommandKind::Read;
  command.result = std::move(type);
  return command;
}

inline model::Event event(const std::string& name, model::Type type) {
  model::Event result;
  result.member = result.name = name;
  result.wireName = model::camelCase(name);
  result.payload.push_back(std::move(type));
  return result;
}

/// Returns a task that requires the contract of header().
inline model::Component task() {
  model::Component result;
  result.name = "demo::Task";
  result.ports = {{"contract_", "Contract", "demo::Contract", false, false, {}, {}}};
  return result;
}

/// demo::Sample {double x}, demo::Contract {write move, read measured, event moved}, and task().
inline model::Header header() {
  model::Header result;
  result.path = "demo.h";
  result.cxxNamespace = "demo";
  model::Struct sample;
  sample.name = "demo::Sample";
  sample.wireName = "Sample";
  sample.fields.push_back(field("x", number()));
  result.structs.push_back(sample);
  model::Interface contract;
  contract.name = "demo::Contract";
  contract.wireName = "Contract";
  contract.commands = {write("move", named("demo::Sample")), read("measured", number())};
  contract.events = {event("moved", number())};
  result.interfaces.push_back(contract);
  result.components = {task()};
  return result;
}

/// Returns the slugs of what the checks find, in order.
inline std::vector<std::string> slugs(std::vector<model::Header> headers) {
  std::vector<std::string> result;
  for (const model::Diagnostic& finding : check(model::Model{std::move(headers)})) {
    result.push_back(finding.slug);
  }
  return result;
}

inline std::vector<std::string> slugs(const model::Header& header) {
  return slugs(std::vector<model::Header>{header});
}

}  // namespace suture::compiler::check::samples
