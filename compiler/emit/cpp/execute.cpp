#include <utility>

#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/parts.h"

namespace suture::compiler::emit {
namespace {

/// Returns "implementation.servo_cp(scratch.servo_cp_goal)". A command that shares its name with
/// other member functions is called by its pointer, since C++ might choose another of them.
std::string call(const model::Interface& interface, const model::Command& command,
                 const MemberNames& names) {
  std::string arguments;
  for (const model::Parameter& parameter : command.parameters) {
    if (!arguments.empty()) arguments += std::string(", ") + kBreak;
    arguments += "scratch." + scratchName(interface, command, parameter);
  }
  const std::string method = command.isOverloaded
                                 ? "(implementation.*" + methodPointer(command, names) + ")"
                                 : "implementation." + command.name;
  return method + "(" + arguments + ")";
}

/// Holds what a command's function needs, in the words of its declaration or of its call.
struct Needs {
  std::string implementation, scratch, arguments, result;
};

std::string listed(const model::Command& command, const Needs& needs) {
  std::string text = needs.implementation;
  if (!command.parameters.empty()) {
    text += ", " + (kBreak + needs.scratch) + ", " + (kBreak + needs.arguments);
  }
  if (command.result) text += ", " + (kBreak + needs.result);
  return text;
}

/// Emits the function that runs one command, so that a stack names it.
void emitFunction(Code& code, const Context& context, const model::Interface& interface,
                  const model::Command& command, const MemberNames& names) {
  code.open("static Errc execute_", command.name, "(", kBreakText,
            listed(command, {"Contract& implementation", "Scratch& scratch",
                             "const std::byte* arguments", "std::byte* result"}),
            ") {");
  if (!command.parameters.empty()) {
    code.line("const auto& slot = ", kBreakText, "slotIn<",
              rooted(argumentsStruct(interface, command, context)), ">(arguments);");
    for (const model::Parameter& parameter : command.parameters) {
      code.line("load(slot.", parameter.name, ", ", kBreakText, "scratch.",
                scratchName(interface, command, parameter), ");");
    }
  }
  if (command.result) {
    const std::string answer = command.parameters.empty() ? "slot" : "answer";
    code.line("auto& ", answer, " = ", kBreakText, "newSlot<",
              slotType(*command.result, context, "suture"), ">(result);");
    code.line("return store(", call(interface, command, names), ", ", kBreakText, answer, ") ",
              kBreakText, "? Errc{} : Errc::TooLarge;");
  } else {
    code.line(call(interface, command, names), ";").line("return Errc{};");
  }
  code.close("}");
}

void emitFunctions(Code& code, const Context& context, const model::Interface& interface) {
  code.line("// A function for each command of ", interface.name,
            ", so that a stack in a debugger names it.");
  code.open("struct Provided<", rooted(interface.name), ">::Dispatch {");
  const MemberNames names(interface);
  bool first = true;
  for (const model::Command* const command : ownCommands(interface)) {
    if (!std::exchange(first, false)) code.blank();
    emitFunction(code, context, interface, *command, names);
  }
  code.close("};").blank();
}

void emitCase(Code& code, const Context& context, const model::Interface& interface,
              const model::Command& command) {
  const std::string needs = listed(command, {"implementation_", "scratch_", "arguments", "result"});
  code.choice("case " + prefixOf(interface, context) + "Command::" + command.name + ":",
              "return Dispatch::execute_" + command.name + "(" + kBreak + needs + ");");
}

}  // namespace

void emitReserved(Code& code, const Context& context, const model::Interface& interface) {
  const std::vector<Argument> arguments = reservedArguments(interface, context.lookup);
  if (arguments.empty()) return;
  code.open("auto Provided<", rooted(interface.name), ">::Scratch::reserved() -> Scratch {");
  code.line("Scratch scratch;");
  for (const auto& [command, parameter] : arguments) {
    code.line("reserveFor<decltype(", rooted(argumentsStruct(interface, command, context)),
              "::", parameter.name, ")>(", kBreakText, "scratch.",
              scratchName(interface, command, parameter), ");");
  }
  code.line("return scratch;").close("}").blank();
}

void emitExecute(Code& code, const Context& context, const model::Interface& interface) {
  const std::vector<const model::Command*> own = ownCommands(interface);
  const bool derives = !interface.base.empty();
  if (derives && own.empty()) return;  // the base's execute() does it
  if (!own.empty()) emitFunctions(code, context, interface);
  const bool any = !own.empty();
  bool takes = derives;
  bool answers = derives;
  for (const model::Command* const command : own) {
    takes = takes || !command->parameters.empty();
    answers = answers || command->result.has_value();
  }
  code.open("Errc Provided<", rooted(interface.name), ">::execute(", kBreakText, "std::uint16_t ",
            named("command", any), ", ", kBreakText, "const std::byte* ", named("arguments", takes),
            ", ", kBreakText, "std::byte* ", named("result", answers), ") {");
  if (any) {
    code.line("using ::", generatedName(interface.name, context.lookup), "Command;");
    code.open("switch (command) {");
    for (const model::Command* const command : own) emitCase(code, context, interface, *command);
    code.close("}");
  }
  const std::string rest =
      derives ? "Provided<" + rooted(interface.base) + ">::execute(command, arguments, result)"
              : "Errc::Invalid";
  code.line("return ", rest, ";").close("}").blank();
}

}  // namespace suture::compiler::emit
