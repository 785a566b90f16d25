#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check/rules.h"
#include "compiler/model/generated_names.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace {

using model::CommandKind;

// Generated code uses these names itself, so no command, or no event, may have them.
constexpr std::array<std::string_view, 7> kTakenFromCommands{"on",      "Events",  "Contract", "Id",
                                                             "EventId", "events_", "Required"};
constexpr std::array<std::string_view, 3> kTakenFromEvents{"Events", "provided", "required"};

/// `numbers` names the structs that generated code gives a member for each such declaration. In C++
/// no member may have the name of its struct.
template <std::size_t N>
void checkName(const std::string& what, const std::string& name,
               const std::array<std::string_view, N>& taken,
               const std::vector<std::string>& numbers, const model::Source& source,
               model::Diagnostics& findings) {
  const auto isIn = [&](const auto& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (!isIn(taken) && !isIn(numbers)) return;
  addError(findings, source, "taken-name",
           what + " '" + name + "' has a name that generated code needs for itself",
           "call it otherwise");
}

bool isAnswered(CommandKind kind) { return kind != CommandKind::Read; }

void checkCommand(const model::Command& command, model::Diagnostics& findings) {
  const std::string subject = "command '" + command.name + "'";
  if (command.deadlineNanoseconds && *command.deadlineNanoseconds <= 0) {
    addError(findings, command.source, "deadline-range",
             subject + " has a deadline() that is not positive; no answer could come in time",
             "give how long a caller shall wait, such as deadline(50ms)");
  }
  if (command.deadlineNanoseconds && !isAnswered(command.kind)) {
    addError(findings, command.source, "deadline-on-read",
             subject + " is a read, which never waits, but has a deadline()",
             "drop it; fresh().within(limit) says how long to wait for an evaluation");
  }
  if (command.concurrent && command.kind != CommandKind::QualifiedRead) {
    addError(findings, command.source, "concurrent-kind",
             subject + " is concurrent() but not a qualified read",
             "only a const command with parameters may run while the component runs");
  }
  const bool queued = command.kind == CommandKind::Void || command.kind == CommandKind::Write;
  if (command.direct && (!queued || command.latest)) {
    addError(findings, command.source, "direct-kind",
             subject + " is direct() but not a queued void or write command",
             "drop it; reads and latest() commands do not queue");
  }
}

void checkInterface(const model::Interface& interface, const model::Lookup& lookup,
                    model::Diagnostics& findings) {
  const std::string name = "contract '" + model::unqualified(interface.name) + "'";
  if (interface.version == 0) {
    addError(findings, interface.source, "version-range", name + " has version(0)",
             "versions count from 1");
  }
  const std::string prefix = model::unqualified(model::generatedName(interface.name, lookup));
  for (const model::Command& command : interface.commands) {
    std::vector<std::string> numbers{prefix + "Command"};
    if (command.kind == CommandKind::Read) numbers.push_back(prefix + "Column");
    checkName("command", command.name, kTakenFromCommands, numbers, command.source, findings);
    checkCommand(command, findings);
  }
  for (const model::Event& event : interface.events) {
    checkName("event", event.name, kTakenFromEvents, {prefix + "Event"}, event.source, findings);
  }
}

}  // namespace

void checkContracts(const model::Header& header, const model::Lookup& lookup,
                    model::Diagnostics& findings) {
  for (const model::Interface& interface : header.interfaces) {
    checkInterface(interface, lookup, findings);
  }
}

}  // namespace suture::compiler::check
