#include <functional>
#include <optional>
#include <set>

#include "compiler/check/rules.h"
#include "compiler/check/type_tree.h"
#include "compiler/model/flat_size.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

constexpr std::uint64_t kLargestSlot = 16u << 20;

/// This is one type that a contract carries, and the place where it does.
struct Carried {
  std::string subject;
  const model::Type& type;
  const model::Source& source;
};

/// Calls `visit` for each type that the contract carries.
void forEachCarried(const model::Interface& contract,
                    const std::function<void(const Carried&)>& visit) {
  for (const model::Command& command : contract.commands) {
    for (const model::Parameter& parameter : command.parameters) {
      visit({"parameter '" + parameter.name + "' of command '" + command.name + "'", parameter.type,
             parameter.source});
    }
    if (command.result) {
      visit({"the result of command '" + command.name + "'", *command.result, command.source});
    }
  }
  for (const model::Event& event : contract.events) {
    for (const model::Type& payload : event.payload) {
      visit({"the payload of event '" + event.name + "'", payload, event.source});
    }
  }
}

/// Returns the first place in the type that has no bound.
std::optional<Place> firstOpen(const model::Type& type, const model::Lookup& lookup) {
  std::optional<Place> found;
  walk(type, lookup, [&](const Place& place) {
    if (place.recursive || isOpen(place.type)) found.emplace(place);
    return !found;
  });
  return found;
}

void checkSize(const Carried& carried, const model::Lookup& lookup, model::Diagnostics& findings) {
  if (firstOpen(carried.type, lookup) || flatSize(carried.type, lookup) <= kLargestSlot) return;
  addError(
      findings, carried.source, "slot-size",
      carried.subject + " needs more than " + std::to_string(kLargestSlot) + " bytes at its bounds",
      "lower its capacity(); every place in a queue has room for the largest value");
}

/// Judges what a task connects by one of its interfaces.
class TaskPort {
 public:
  TaskPort(const model::Component& task, const model::Port& port, const model::Lookup& lookup,
           model::Diagnostics& findings)
      : beginning_("task '" + model::unqualified(task.name) + "' " +
                   (port.provided ? "provides" : "requires") + " '" +
                   model::unqualified(port.interface) + "', where "),
        port_(port),
        lookup_(lookup),
        findings_(findings) {}

  void check(const Carried& carried) {
    const std::optional<Place> open = firstOpen(carried.type, lookup_);
    if (!open) return;
    model::Diagnostic& finding =
        open->recursive ? reportRecursive(carried, *open) : reportOpen(carried, *open);
    finding.notes.push_back({carried.source, "the contract has it here"});
    if (open->field) finding.notes.push_back({open->field->source, "the field is here"});
  }

 private:
  model::Diagnostic& reportRecursive(const Carried& carried, const Place& place) {
    return addError(findings_, port_.source, "recursive-type",
                    beginning_ + carried.subject + " has no bound: '" + place.field->name +
                        "' leads back to '" + model::unqualified(place.type.name) + "'",
                    "for a task, keep a flat list of nodes that refer to each other by index");
  }

  model::Diagnostic& reportOpen(const Carried& carried, const Place& place) {
    const model::Type& type = carried.type;
    const std::string name = type.name.empty() ? type.spelling : model::unqualified(type.name);
    const std::string what = place.path.empty() ? "" : name + "." + place.path + " is a ";
    return addError(findings_, port_.source, "unbounded-contract",
                    beginning_ + carried.subject + " has no bound: " + what + place.type.spelling +
                        " without capacity()",
                    std::string("add SUTURE_FIELD(capacity(n)) to ") +
                        (place.field ? "the field" : "it") +
                        ", one number for each string or list; only devices do without");
  }

  std::string beginning_;
  const model::Port& port_;
  const model::Lookup& lookup_;
  model::Diagnostics& findings_;
};

}  // namespace

void checkBounds(const model::Header& header, const model::Lookup& lookup,
                 model::Diagnostics& findings) {
  for (const model::Interface& contract : header.interfaces) {
    forEachCarried(contract, [&](const Carried& carried) { checkSize(carried, lookup, findings); });
  }
  for (const model::Component& component : header.components) {
    if (component.base != model::ComponentBase::Task) continue;
    std::set<std::string> judged;
    for (const model::Port& port : component.ports) {
      const model::Interface* const contract = lookup.findInterface(port.interface);
      if (contract == nullptr || !judged.insert(port.interface).second) continue;
      TaskPort task(component, port, lookup, findings);
      forEachCarried(*contract, [&](const Carried& carried) { task.check(carried); });
    }
  }
}

}  // namespace suture::compiler::check
