#include <algorithm>

#include "compiler/emit/text/call_words.h"
#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/parts.h"
#include "compiler/lock/schema/wire_type.h"

namespace suture::compiler::emit {
namespace {

using model::CommandKind;

/// Everything here lies in namespace suture, where user names are spelled in full.
constexpr char kHome[] = "suture";

std::string argumentsSlot(const Context& context, const model::Interface& interface,
                          const model::Command& command) {
  return command.parameters.empty() ? "NoSlot"
                                    : rooted(argumentsStruct(interface, command, context));
}

/// Returns "ReadCommand<&Contract::measured_cp, robots::PoseStampedSlot>".
std::string memberType(const Context& context, const model::Interface& interface,
                       const model::Command& command) {
  const std::string method = methodPointer(command);
  const auto result = [&] { return slotType(*command.result, context, kHome); };
  switch (command.kind) {
    case CommandKind::Void:
    case CommandKind::Write:
      return "Command<" + method + ", " + kBreak + argumentsSlot(context, interface, command) + ">";
    case CommandKind::Read: return "ReadCommand<" + method + ", " + kBreak + result() + ">";
    case CommandKind::QualifiedRead:
      return "QualifiedReadCommand<" + method + ", " + kBreak +
             argumentsSlot(context, interface, command) + ", " + kBreak + result() + ">";
    case CommandKind::VoidReturn:
    case CommandKind::WriteReturn:
      return "ReturningCommand<" + method + ", " + kBreak +
             argumentsSlot(context, interface, command) + ", " + kBreak + result() + ">";
  }
  return "";
}

/// Says what an editor shall show beside the command's documentation.
std::string wayOf(const model::Command& command) {
  std::string words = callWords(command);
  for (const model::Parameter& one : command.parameters) {
    words += limitWords("`" + one.name + "`", {one.unit, one.range});
  }
  return words + limitWords("The answer", {command.resultUnit, command.resultRange});
}

template <class Member>
bool isDeprecated(const Member* member) {
  return !member->lifecycle.deprecated.empty();
}

template <class Member>
void emitDeprecation(Code& code, const Member* member) {
  if (!isDeprecated(member)) return;
  code.line("[[deprecated(", lock::quoted(member->lifecycle.deprecated), ")]]");
}

/// Silences warnings in a constructor: it initialises all members, also those that users should not
/// use.
template <class Member, class EmitConstructor>
void withoutWarning(Code& code, const std::vector<const Member*>& members,
                    const EmitConstructor& emitIt) {
  const bool quiet = std::any_of(members.begin(), members.end(), isDeprecated<Member>);
  if (quiet) code.verbatim("#pragma GCC diagnostic push\n");
  if (quiet) code.verbatim("#pragma GCC diagnostic ignored \"-Wdeprecated-declarations\"\n");
  emitIt();
  if (quiet) code.verbatim("#pragma GCC diagnostic pop\n");
}

void emitEvents(Code& code, const Context& context, const model::Interface& interface) {
  const std::string base = baseClass("Required", interface);
  code.blank().line("/// Subscribes to the events of ", interface.name, ".");
  emitEventsHead(code, interface, base);
  withoutWarning(code, ownEvents(interface), [&] {
    emitEventConstructor(code, interface, base, "RequiredBase& required", "required");
  });
  code.blank();
  for (const model::Event* const event : ownEvents(interface)) {
    code.doc(event->doc.text).remark(deliveryWords(*event));
    emitDeprecation(code, event);
    code.line("Subscription<", eventArguments(context, interface, *event), "> ", event->name, ";");
  }
  code.close("};").line("Events& on() { return events_; }");
}

/// Returns a name for a parameter that hides no command.
std::string freeName(std::string name, const model::Interface& interface) {
  const auto& all = interface.commands;
  const auto isTaken = [&](const model::Command& command) { return command.name == name; };
  while (std::any_of(all.begin(), all.end(), isTaken)) name += "Given";
  return name;
}

void emitConstructor(Code& code, const model::Interface& interface) {
  const std::string owner = freeName("owner", interface), name = freeName("name", interface);
  code.line("Required(Component& ", owner, ", std::string_view ", name, ")");
  code.line("    : Required(", owner, ", ", name, ", interfaceInfo<Contract>()) {}").blank();
}

void emitProtectedConstructor(Code& code, const model::Interface& interface) {
  const std::string owner = freeName("owner", interface), name = freeName("name", interface),
                    info = freeName("info", interface);
  code.blank().label("protected:").line("// For contracts that derive from this one.");
  withoutWarning(code, ownCommands(interface), [&] {
    code.line("Required(Component& ", owner, ", ", kBreakText, "std::string_view ", name, ", ",
              kBreakText, "const InterfaceInfo& ", info, ")");
    code.line("    : ", baseClass("Required", interface), "(", owner, ", ", name, ", ", info,
              ") {}");
  });
}

}  // namespace

void emitRequired(Code& code, const Context& context, const model::Interface& interface) {
  code.line("/// Calls ", interface.name, " of another component.").line("template <>");
  code.open("class Required<", rooted(interface.name), "> : public ",
            baseClass("Required", interface), " {");
  code.line("using Contract = ", rooted(interface.name), ";");
  emitNumberAliases(code, context, interface);
  code.blank().label("public:");
  emitConstructor(code, interface);
  for (const model::Command* const command : ownCommands(interface)) {
    code.doc(command->doc.text).remark(wayOf(*command));
    emitDeprecation(code, command);
    code.line(memberType(context, interface, *command), " ", command->name, "{", kBreakText,
              "*this, Id::", command->name, "};");
  }
  const bool events = !ownEvents(interface).empty();
  if (events) emitEvents(code, context, interface);
  emitProtectedConstructor(code, interface);
  if (events) code.blank().label("private:").line("Events events_{*this};");
  code.close("};").blank();
}

}  // namespace suture::compiler::emit
