#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

#include "compiler/check/rules.h"
#include "compiler/model/naming.h"
#include "compiler/model/reserved_names.h"

namespace suture::compiler::check {
namespace {

bool isAlphanumeric(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) {
    const auto u = static_cast<unsigned char>(c);
    return u < 128 && std::isalnum(u);
  });
}

constexpr std::string_view kNameAdvice = "choose another with name(\"...\"); the C++ name stays";

/// Holds the names of one scope, which two things cannot share.
class Scope {
 public:
  Scope(bool types, model::Diagnostics& findings) : types_(types), findings_(findings) {}

  void add(const std::string& what, const std::string& name, const std::string& wireName,
           const model::Source& source) {
    checkSpelling(what + " '" + name + "'", wireName, source);
    const auto [first, added] = taken_.emplace(wireName, Entry{what + " '" + name + "'", source});
    if (added) return;
    addError(findings_, source, "wire-name-clash",
             first->second.subject + " and " + what + " '" + name + "' both map to wire name '" +
                 wireName + "'",
             "tell them apart with name(\"...\") on one of them")
        .notes.push_back({first->second.source, "the first is here"});
  }

 private:
  struct Entry {
    std::string subject;
    model::Source source;
  };

  void checkSpelling(const std::string& subject, const std::string& wireName,
                     const model::Source& source) {
    const auto first = static_cast<unsigned char>(wireName.empty() ? '\0' : wireName[0]);
    if (isAlphanumeric(wireName) && (types_ ? std::isupper(first) : std::islower(first))) return;
    addError(findings_, source, "wire-name",
             "the wire name '" + wireName + "' of " + subject + " is not " +
                 (types_ ? "a capital letter" : "a small letter") +
                 " followed by letters and digits",
             std::string(kNameAdvice));
  }

  const bool types_;
  model::Diagnostics& findings_;
  std::map<std::string, Entry> taken_;
};

void checkReserved(model::Named kind, const std::string& name, const std::string& wireName,
                   const model::Source& source, model::Diagnostics& findings) {
  if (!model::isReserved(kind, wireName)) return;
  const bool interface = kind == model::Named::Contract;
  addError(findings, source, "reserved-name",
           "'" + name + "' cannot be '" + wireName + "' on the wire: Cap'n Proto needs that name",
           "write " + std::string(interface ? "SUTURE_INTERFACE" : "SUTURE_TYPE") + "(name(\"" +
               wireName + (interface ? "Interface" : "Type") + "\")); the C++ name stays");
}

/// Holds the macros of the model.
using Macros = std::map<std::string, model::MacroOrigin>;

/// Tells if the enumerator of capnp's C++ would be replaced within the very file that capnp writes.
/// Generated code copes with macros of the headers that it includes behind that.
bool isGivenMacro(const std::string& constant, const Macros& macros) {
  const auto found = macros.find(constant);
  return found != macros.end() && found->second == model::MacroOrigin::CommandLine;
}

void checkEnumerators(const model::Enum& type, const Macros& macros, model::Diagnostics& findings) {
  Scope scope(false, findings);
  for (const model::Enumerator& enumerator : type.enumerators) {
    scope.add("enumerator", enumerator.name, enumerator.wireName, enumerator.source);
    const std::string constant = model::upperSnakeCase(enumerator.wireName);
    if (isGivenMacro(constant, macros)) {
      addError(findings, enumerator.source, "macro-name",
               "enumerator '" + enumerator.name + "' becomes " + constant +
                   " in capnp's C++, which the command line defines as a macro",
               "choose another with name(\"...\"), or call the macro otherwise");
    }
    if (!model::isReserved(model::Named::Enumerator, enumerator.wireName)) continue;
    addError(findings, enumerator.source, "macro-name",
             "enumerator '" + enumerator.name + "' would become " + constant +
                 " in capnp's C++, which is a macro of the C library",
             "choose another name(), or none");
  }
}

void checkBuiltIn(model::Named kind, const std::string& subject, const std::string& wireName,
                  const model::Source& source, model::Diagnostics& findings) {
  if (!model::isReserved(kind, wireName)) return;
  addError(findings, source, "built-in-name",
           subject + " maps to wire name '" + wireName + "', which suturec uses itself there",
           std::string(kNameAdvice));
}

void checkNamesOf(const model::Interface& interface, model::Diagnostics& findings) {
  Scope commands(false, findings), events(false, findings);
  std::map<std::string, const model::Command*> first;
  for (const model::Command& command : interface.commands) {
    const auto [other, isNew] = first.emplace(command.name, &command);
    if (!isNew && command.inheritedFrom.empty() && other->second->inheritedFrom.empty()) {
      addError(findings, command.source, "taken-name",
               "command '" + command.name +
                   "' has the C++ name of another command, and what is "
                   "generated for both would be called alike",
               "give it a name of its own; name() changes the name on the wire only")
          .notes.push_back({other->second->source, "the other is here"});
      continue;
    }
    commands.add("command", command.name, command.wireName, command.source);
    const std::string subject = "command '" + command.name + "'";
    const bool reads = command.kind == model::CommandKind::Read;
    checkBuiltIn(reads ? model::Named::Read : model::Named::Command, subject, command.wireName,
                 command.source, findings);
    Scope parameters(false, findings);
    for (const model::Parameter& parameter : command.parameters) {
      parameters.add("parameter", parameter.name, parameter.wireName, parameter.source);
      checkBuiltIn(model::Named::Parameter, "parameter '" + parameter.name + "'",
                   parameter.wireName, parameter.source, findings);
    }
  }
  for (const model::Event& event : interface.events) {
    events.add("event", event.name, event.wireName, event.source);
    checkBuiltIn(model::Named::Event, "event '" + event.name + "'", event.wireName, event.source,
                 findings);
  }
}

}  // namespace

void checkNames(const model::Header& header, const model::Model& model,
                model::Diagnostics& findings) {
  Scope types(true, findings);
  for (const model::Enum& type : header.enums) {
    types.add("type", type.name, type.wireName, type.source);
    checkReserved(model::Named::Type, type.name, type.wireName, type.source, findings);
    checkEnumerators(type, model.macros, findings);
  }
  for (const model::Struct& type : header.structs) {
    types.add("type", type.name, type.wireName, type.source);
    checkReserved(model::Named::Type, type.name, type.wireName, type.source, findings);
    Scope fields(false, findings);
    for (const model::Field& field : type.fields) {
      fields.add("field", field.name, field.wireName, field.source);
    }
  }
  for (const model::Interface& interface : header.interfaces) {
    types.add("contract", interface.name, interface.wireName, interface.source);
    types.add("the events of contract", interface.name, interface.wireName + "Events",
              interface.source);
    types.add("the state of contract", interface.name, interface.wireName + "StateRow",
              interface.source);
    checkReserved(model::Named::Contract, interface.name, interface.wireName, interface.source,
                  findings);
    checkNamesOf(interface, findings);
  }
}

}  // namespace suture::compiler::check
