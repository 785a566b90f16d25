#include "compiler/frontend/imports.h"

#include <set>

#include "compiler/model/lookup.h"

namespace suture::compiler::frontend {
namespace {

void collect(const model::Type& type, std::set<std::string>& names) {
  if (!type.name.empty()) names.insert(type.name);
  for (const model::Type& element : type.element) collect(element, names);
}

std::set<std::string> namesUsedBy(const model::Header& header) {
  std::set<std::string> names;
  for (const model::Struct& type : header.structs) {
    for (const model::Field& field : type.fields) collect(field.type, names);
  }
  for (const model::Interface& interface : header.interfaces) {
    if (!interface.base.empty()) names.insert(interface.base);
    for (const model::Command& command : interface.commands) {
      for (const model::Parameter& parameter : command.parameters) collect(parameter.type, names);
      if (command.result) collect(*command.result, names);
    }
    for (const model::Event& event : interface.events) {
      for (const model::Type& payload : event.payload) collect(payload, names);
    }
  }
  for (const model::Component& component : header.components) {
    if (component.parameters) names.insert(*component.parameters);
    for (const model::Port& port : component.ports) names.insert(port.interface);
  }
  return names;
}

}  // namespace

void addImports(model::Model& model) {
  const model::Lookup lookup(model);
  std::vector<std::vector<std::string>> imports;
  for (const model::Header& header : model.headers) {
    std::set<std::string> paths;
    for (const std::string& name : namesUsedBy(header)) {
      const model::Header* home = lookup.headerOf(name);
      if (home && home != &header) paths.insert(home->path);
    }
    imports.emplace_back(paths.begin(), paths.end());
  }
  for (std::size_t i = 0; i < imports.size(); ++i) model.headers[i].imports = std::move(imports[i]);
}

}  // namespace suture::compiler::frontend
