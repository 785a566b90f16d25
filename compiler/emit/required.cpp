#include <algorithm>

#include "compiler/emit/contract.h"
#include "compiler/emit/parts.h"
#include "compiler/lock/wire_type.h"

namespace suture::compiler::emit {
namespace {

using model::CommandKind;

/// Everything here lies in namespace suture, where user names are spelled in full.
constexpr char kHome[] = "suture";

std::string argumentsSlot(const model::Interface& interface, const model::Command& command) {
  return command.parameters.empty() ? "NoSlot" : argumentsStruct(interface, command);
}

/// "ReadCommand<&Contract::measured_cp, robots::PoseStampedSlot>".
std::string memberType(const Context& context, const model::Interface& interface,
                       const model::Command& command) {
  const std::string method = "&Contract::" + command.name;
  const auto result = [&] { return slotType(*command.result, context, kHome); };
  switch (command.kind) {
    case CommandKind::Void:
    case CommandKind::Write:
      return "Command<" + method + ", " + kBreak + argumentsSlot(interface, command) + ">";
    case CommandKind::Read: return "ReadCommand<" + method + ", " + kBreak + result() + ">";
    case CommandKind::QualifiedRead:
      return "QualifiedReadCommand<" + method + ", " + kBreak + argumentsSlot(interface, command) +
             ", " + kBreak + result() + ">";
    case CommandKind::VoidReturn:
    case CommandKind::WriteReturn:
      return "ReturningCommand<" + method + ", " + kBreak + argumentsSlot(interface, command) +
             ", " + kBreak + result() + ">";
  }
  return "";
}

template <class Member>
bool isDeprecated(const Member& member) {
  return !member.lifecycle.deprecated.empty();
}

/// A constructor initialises all members, and shall not be warned of those that users should not
/// use.
template <class Member, class EmitConstructor>
void withoutWarning(Code& code, const std::vector<Member>& members, const EmitConstructor& emitIt) {
  const bool quiet = std::any_of(members.begin(), members.end(), isDeprecated<Member>);
  if (quiet) code.verbatim("#pragma GCC diagnostic push\n");
  if (quiet) code.verbatim("#pragma GCC diagnostic ignored \"-Wdeprecated-declarations\"\n");
  emitIt();
  if (quiet) code.verbatim("#pragma GCC diagnostic pop\n");
  code.blank();
}

template <class Member>
void emitDeprecation(Code& code, const Member& member) {
  if (!isDeprecated(member)) return;
  code.line("[[deprecated(", lock::quoted(member.lifecycle.deprecated), ")]]");
}

void emitEvents(Code& code, const Context& context, const model::Interface& interface) {
  code.blank().line("/// The events of ", interface.name, ", to subscribe to.");
  code.open("struct Events {");
  withoutWarning(code, interface.events, [&] {
    emitEventConstructor(code, interface, "RequiredBase& required", "required");
  });
  for (const model::Event& event : interface.events) {
    code.doc(event.doc.text);
    emitDeprecation(code, event);
    code.line("Subscription<", eventArguments(context, interface, event), "> ", event.name, ";");
  }
  code.close("};").line("Events& on() { return events_; }");
  code.blank().label("private:").line("Events events_{*this};");
}

/// A parameter's name that hides no command.
std::string freeName(std::string name, const model::Interface& interface) {
  const auto& all = interface.commands;
  const auto isTaken = [&](const model::Command& command) { return command.name == name; };
  while (std::any_of(all.begin(), all.end(), isTaken)) name += "Given";
  return name;
}

void emitConstructor(Code& code, const model::Interface& interface) {
  const std::string owner = freeName("owner", interface), name = freeName("name", interface);
  withoutWarning(code, interface.commands, [&] {
    code.line("Required(Component& ", owner, ", std::string_view ", name, ")");
    code.line("    : RequiredBase(", owner, ", ", name, ", interfaceInfo<Contract>()) {}");
  });
}

}  // namespace

void emitRequired(Code& code, const Context& context, const model::Interface& interface) {
  code.line("/// What a client of ", interface.name, " calls.").line("template <>");
  code.open("class Required<", interface.name, "> final : public RequiredBase {");
  code.line("using Contract = ", interface.name, ";");
  emitNumberAliases(code, interface);
  code.blank().label("public:");
  emitConstructor(code, interface);
  for (const model::Command& command : interface.commands) {
    code.doc(command.doc.text);
    emitDeprecation(code, command);
    code.line(memberType(context, interface, command), " ", command.name, "{", kBreakText,
              "*this, static_cast<std::uint16_t>(Id::", command.name, ")};");
  }
  if (!interface.events.empty()) emitEvents(code, context, interface);
  code.close("};").blank();
}

}  // namespace suture::compiler::emit
