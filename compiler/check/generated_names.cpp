#include <map>
#include <set>
#include <string>

#include "compiler/check/rules.h"
#include "compiler/model/generated_names.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

constexpr char kHelp[] = "choose another C++ name for one of them";
constexpr char kHelpOnTypes[] =
    "choose another C++ name for one of them; name a foreign one in a header of another namespace";

/// Holds what generated code declares for types, commands and events, each once.
class Structs {
 public:
  explicit Structs(model::Diagnostics& findings) : findings_(findings) {}

  void add(const std::string& name, const std::string& subject, const model::Source& source,
           bool isOwn, const std::string& help = kHelp) {
    const auto [first, isNew] = taken_.emplace(name, Entry{subject, source});
    if (isNew || !isOwn) return;
    addError(findings_, source, "generated-name",
             "the code generated for " + subject + " and that for " + first->second.subject +
                 " both declare '" + name + "'",
             help)
        .notes.push_back({first->second.source, "the other is here"});
  }

 private:
  struct Entry {
    std::string subject;
    model::Source source;
  };

  model::Diagnostics& findings_;
  std::map<std::string, Entry> taken_;
};

void addStructs(const model::Header& header, const model::Lookup& lookup, bool isOwn,
                Structs& structs) {
  for (const model::Struct& one : header.structs) {
    structs.add(model::generatedName(one.name, lookup) + "Slot", "type '" + one.name + "'",
                one.source, isOwn, kHelpOnTypes);
  }
  for (const model::Enum& one : header.enums) {
    const std::string name = model::generatedName(one.name, lookup);
    const std::string space = model::namespaceOf(name);
    structs.add((space.empty() ? "" : space + "::") + "isKnown" + model::unqualified(name),
                "type '" + one.name + "'", one.source, isOwn, kHelpOnTypes);
  }
}

void addStructs(const model::Interface& interface, const model::Lookup& lookup, bool isOwn,
                Structs& structs) {
  const std::string of = "' of contract '" + model::unqualified(interface.name) + "'";
  std::set<std::string> names, commands, events;  // other rules refuse what is in one twice
  for (const model::Command& command : interface.commands) {
    if (!command.inheritedFrom.empty() || command.parameters.empty()) continue;
    if (!names.insert(command.name).second || !commands.insert(command.wireName).second) continue;
    structs.add(model::argumentsStruct(interface, command, lookup), "command '" + command.name + of,
                command.source, isOwn);
  }
  for (const model::Event& event : interface.events) {
    if (!event.inheritedFrom.empty() || event.payload.size() < 2) continue;
    if (!events.insert(event.wireName).second) continue;
    structs.add(model::payloadStruct(interface, event, lookup), "event '" + event.name + of,
                event.source, isOwn);
  }
}

}  // namespace

void checkGeneratedNames(const model::Model& model, const model::Lookup& lookup,
                         model::Diagnostics& findings) {
  Structs structs(findings);
  // The target's own headers come last, so that the finding is in one that the user can change.
  for (const bool own : {false, true}) {
    for (const model::Header& header : model.headers) {
      if (header.own != own) continue;
      addStructs(header, lookup, own, structs);
      for (const model::Interface& one : header.interfaces) addStructs(one, lookup, own, structs);
    }
  }
}

}  // namespace suture::compiler::check
