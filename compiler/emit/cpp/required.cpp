#include <algorithm>

#include "compiler/emit/text/call_words.h"
#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/member_names.h"
#include "compiler/emit/text/parts.h"
#include "compiler/lock/schema/wire_type.h"

namespace suture::compiler::emit {
namespace {

using model::CommandKind;

/// Everything here lies in namespace suture, where user names are spelled in full.
constexpr char kHome[] = "suture";

std::string argumentsSlot(const Context& context, const model::Interface& interface,
                          const model::Command& command, const MemberNames& names) {
  return command.parameters.empty() ? names.spell("NoSlot")
                                    : rooted(argumentsStruct(interface, command, context));
}

/// Returns "ReadCommand<&Contract::measured_cp, robots::PoseStampedSlot>".
std::string memberType(const Context& context, const model::Interface& interface,
                       const model::Command& command, const MemberNames& names) {
  const std::string method = methodPointer(command, names);
  const auto arguments = [&] { return argumentsSlot(context, interface, command, names); };
  const auto result = [&] { return names.spell(slotType(*command.result, context, kHome)); };
  const auto member = [&](const char* name, const std::string& slots) {
    return names.spell(name) + "<" + method + ", " + kBreak + slots + ">";
  };
  switch (command.kind) {
    case CommandKind::Void:
    case CommandKind::Write: return member("Command", arguments());
    case CommandKind::Read: return member("ReadCommand", result());
    case CommandKind::QualifiedRead:
      return member("QualifiedReadCommand", arguments() + ", " + kBreak + result());
    case CommandKind::VoidReturn:
    case CommandKind::WriteReturn:
      return member("ReturningCommand", arguments() + ", " + kBreak + result());
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

void emitEvents(Code& code, const Context& context, const model::Interface& interface,
                const MemberNames& names) {
  const std::string base = names.spell(baseClass("Required", interface));
  code.blank().line("/// Subscribes to the events of ", interface.name, ".");
  emitEventsHead(code, interface, base);
  withoutWarning(code, ownEvents(interface), [&] {
    emitEventConstructor(code, interface, base, names.spell("RequiredBase") + "& required",
                         "required");
  });
  code.blank();
  for (const model::Event* const event : ownEvents(interface)) {
    code.doc(event->doc.text).remark(deliveryWords(*event));
    emitDeprecation(code, event);
    code.line(names.spell("Subscription"), "<", eventArguments(context, interface, *event, names),
              "> ", event->name, ";");
  }
  code.close("};").line("Events& on() { return events_; }");
}

void emitConstructor(Code& code, const model::Interface& interface, const MemberNames& names) {
  const std::string owner = freeName("owner", interface.commands),
                    name = freeName("name", interface.commands);
  code.line("Required(", names.spell("Component"), "& ", owner, ", std::string_view ", name, ")");
  code.line("    : Required(", owner, ", ", name, ", ", names.spell("interfaceInfo"),
            "<Contract>()) {}");
  code.blank();
}

void emitProtectedConstructor(Code& code, const model::Interface& interface,
                              const MemberNames& names) {
  const std::string owner = freeName("owner", interface.commands),
                    name = freeName("name", interface.commands),
                    info = freeName("info", interface.commands);
  code.blank().label("protected:").line("// For contracts that derive from this one.");
  withoutWarning(code, ownCommands(interface), [&] {
    code.line("Required(", names.spell("Component"), "& ", owner, ", ", kBreakText,
              "std::string_view ", name, ", ", kBreakText, "const ", names.spell("InterfaceInfo"),
              "& ", info, ")");
    code.line("    : ", names.spell(baseClass("Required", interface)), "(", owner, ", ", name, ", ",
              info, ") {}");
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
  const MemberNames names(interface);
  emitConstructor(code, interface, names);
  for (const model::Command* const command : ownCommands(interface)) {
    code.doc(command->doc.text).remark(wayOf(*command));
    emitDeprecation(code, command);
    code.line(memberType(context, interface, *command, names), " ", command->name, "{", kBreakText,
              "*this, Id::", command->name, "};");
  }
  const bool events = !ownEvents(interface).empty();
  if (events) emitEvents(code, context, interface, names);
  emitProtectedConstructor(code, interface, names);
  if (events) code.blank().label("private:").line("Events events_{*this};");
  code.close("};").blank();
}

}  // namespace suture::compiler::emit
