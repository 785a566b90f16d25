#include "compiler/emit/contract.h"
#include "compiler/emit/parts.h"

namespace suture::compiler::emit {
namespace {

/// "implementation_.servo_cp(scratch_.servo_cp_goal)".
std::string call(const model::Command& command) {
  std::string arguments;
  for (const model::Parameter& parameter : command.parameters) {
    if (!arguments.empty()) arguments += std::string(", ") + kBreak;
    arguments += "scratch_." + scratchName(command, parameter);
  }
  return "implementation_." + command.name + "(" + arguments + ")";
}

void emitCase(Code& code, const Context& context, const model::Interface& interface,
              const model::Command& command) {
  code.open("case ", prefixOf(interface), "Command::", command.name, ": {");
  if (!command.parameters.empty()) {
    code.line("const auto& slot = ", kBreakText, "*reinterpret_cast<const ",
              argumentsStruct(interface, command), "*>(arguments);");
    for (const model::Parameter& parameter : command.parameters) {
      code.line("load(slot.", parameter.name, ", scratch_.", scratchName(command, parameter), ");");
    }
  }
  if (command.result) {
    const std::string answer = command.parameters.empty() ? "slot" : "answer";
    code.line("auto& ", answer, " = *reinterpret_cast<",
              slotType(*command.result, context, "suture"), "*>(result);");
    code.line("return store(", call(command), ", ", answer, ") ", kBreakText,
              "? Errc{} : Errc::TooLarge;");
  } else {
    code.line(call(command), ";").line("return Errc{};");
  }
  code.close("}");
}

/// The parameter's name, in a comment where nothing uses it.
std::string named(const char* name, bool used) {
  return used ? name : std::string("/*") + name + "*/";
}

}  // namespace

void emitExecute(Code& code, const Context& context, const model::Interface& interface) {
  bool takes = false;
  bool answers = false;
  for (const model::Command& command : interface.commands) {
    takes = takes || !command.parameters.empty();
    answers = answers || command.result.has_value();
  }
  const bool any = !interface.commands.empty();
  code.open("Errc Provided<", interface.name, ">::execute(", kBreakText, "std::uint16_t ",
            named("command", any), ", ", kBreakText, "const std::byte* ", named("arguments", takes),
            ", ", kBreakText, "std::byte* ", named("result", answers), ") {");
  if (any) {
    code.line("using ::", interface.name, "Command;");
    code.open("switch (static_cast<", prefixOf(interface), "Command>(command)) {");
    for (const model::Command& command : interface.commands) {
      emitCase(code, context, interface, command);
    }
    code.close("}");
  }
  code.line("return Errc::Invalid;").close("}").blank();
}

}  // namespace suture::compiler::emit
