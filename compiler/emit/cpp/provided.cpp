#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/member_names.h"
#include "compiler/emit/text/parts.h"

namespace suture::compiler::emit {
namespace {

void emitEvents(Code& code, const Context& context, const model::Interface& interface) {
  const MemberNames names(interface);
  const std::string base = names.spell(baseClass("Provided", interface));
  code.blank().line("/// Emits the events of ", interface.name, ".");
  emitEventsHead(code, interface, base);
  emitEventConstructor(code, interface, base, names.spell("ProvidedBase") + "& provided",
                       "provided");
  code.blank();
  for (const model::Event* const event : ownEvents(interface)) {
    code.doc(event->doc.text);
    code.line(names.spell("Emitter"), "<", eventArguments(context, interface, *event, names), "> ",
              event->name, ";");
  }
  code.close("};").line("Events& emit() { return events_; }");
}

void emitScratch(Code& code, const model::Interface& interface, bool reserves) {
  code.line("// Reused by every command, so that what they own is allocated once",
            reserves ? ": by reserved()." : ".");
  code.open("struct Scratch {");
  for (const model::Command* const command : ownCommands(interface)) {
    for (const model::Parameter& parameter : command->parameters) {
      code.line(cxxType(parameter.type, "suture"), " ", scratchName(interface, *command, parameter),
                "{};");
    }
  }
  if (reserves) code.blank().line("static Scratch reserved();");
  code.close("};").blank();
}

/// Emits the constructor that a derived contract calls, with its information and implementation.
void emitProtectedConstructor(Code& code, const model::Interface& interface, bool implements) {
  code.line("// For contracts that derive from this one: `whole` points to their implementation.");
  code.line("Provided(Component& owner, std::string_view name, ", kBreakText,
            "const InterfaceInfo& info, ", kBreakText, "void* whole, ", kBreakText, "Contract& ",
            named("implementation", implements || !interface.base.empty()), ")");
  const std::string arguments = interface.base.empty() ? "" : ", implementation";
  code.line("    : ", baseClass("Provided", interface), "(owner, name, info, whole", arguments, ")",
            implements ? "," : " {}");
  if (implements) code.line("      implementation_(implementation) {}");
  code.blank();
}

}  // namespace

void emitProvided(Code& code, const Context& context, const model::Interface& interface) {
  const bool scratch = hasOwnParameters(interface);
  const bool reserves = !reservedArguments(interface, context.lookup).empty();
  const bool commands = !ownCommands(interface).empty();
  const bool events = !ownEvents(interface).empty();
  const bool executes = commands || interface.base.empty();
  code.line("/// Serves ", interface.name, " from a component.").line("template <>");
  code.open("class Provided<", rooted(interface.name), "> : public ",
            baseClass("Provided", interface), " {");
  code.line("using Contract = ", rooted(interface.name), ";");
  if (events) {
    code.line("using EventId = ", rooted(generatedName(interface.name, context.lookup)), "Event;");
  }
  code.blank().label("public:");
  code.line("Provided(Component& owner, std::string_view name, Contract& implementation)");
  code.line("    : Provided(owner, name, interfaceInfo<Contract>(), ", kBreakText,
            "&implementation, ", kBreakText, "implementation) {}");
  if (events) emitEvents(code, context, interface);
  code.blank().label("protected:");
  emitProtectedConstructor(code, interface, commands);
  if (executes) {
    code.line("Errc execute(std::uint16_t command, const std::byte* arguments, ", kBreakText,
              "std::byte* result) override;");
    code.blank();
  }
  code.label("private:");
  if (commands) code.line("struct Dispatch;  // has a function for each command").blank();
  if (scratch) emitScratch(code, interface, reserves);
  if (commands) code.line("Contract& implementation_;");
  if (events) code.line("Events events_{*this};");
  if (scratch) code.line("Scratch scratch_", reserves ? " = Scratch::reserved();" : ";");
  code.close("};").blank();
}

}  // namespace suture::compiler::emit
