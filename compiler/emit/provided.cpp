#include "compiler/emit/contract.h"
#include "compiler/emit/parts.h"

namespace suture::compiler::emit {
namespace {

void emitEvents(Code& code, const Context& context, const model::Interface& interface) {
  code.blank().line("/// The events of ", interface.name, ", to emit.");
  code.open("struct Events {");
  emitEventConstructor(code, interface, "ProvidedBase& provided", "provided");
  code.blank();
  for (const model::Event& event : interface.events) {
    code.doc(event.doc.text);
    code.line("Emitter<", eventArguments(context, interface, event), "> ", event.name, ";");
  }
  code.close("};").line("Events& emit() { return events_; }");
}

void emitScratch(Code& code, const model::Interface& interface) {
  code.line("// Reused by every command, so that what they own is allocated once.");
  code.open("struct Scratch {");
  for (const model::Command& command : interface.commands) {
    for (const model::Parameter& parameter : command.parameters) {
      code.line(cxxType(parameter.type, "suture"), " ", scratchName(command, parameter), ";");
    }
  }
  code.close("};").blank();
}

}  // namespace

void emitProvided(Code& code, const Context& context, const model::Interface& interface) {
  const bool scratch = hasParameters(interface);
  code.line("/// What serves ", interface.name, " from a component.").line("template <>");
  code.open("class Provided<", interface.name, "> final : public ProvidedBase {");
  code.line("using Contract = ", interface.name, ";");
  if (!interface.events.empty()) code.line("using EventId = ", interface.name, "Event;");
  code.blank().label("public:");
  code.line("Provided(Component& owner, std::string_view name, Contract& implementation)");
  code.line("    : ProvidedBase(owner, name, interfaceInfo<Contract>(), &implementation),");
  code.line("      implementation_(implementation) {}");
  if (!interface.events.empty()) emitEvents(code, context, interface);
  code.blank().label("private:");
  if (scratch) emitScratch(code, interface);
  code.line("Errc execute(std::uint16_t command, const std::byte* arguments, ", kBreakText,
            "std::byte* result) override;");
  code.blank().line("Contract& implementation_;");
  if (!interface.events.empty()) code.line("Events events_{*this};");
  if (scratch) code.line("Scratch scratch_{};");
  code.close("};").blank();
}

}  // namespace suture::compiler::emit
