#include "compiler/emit/contract.h"
#include "compiler/emit/parts.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

/// "const PoseStamped& goal, const double& time, "
std::string parameterList(const model::Command& command, const std::string& home) {
  std::string text;
  for (const model::Parameter& parameter : command.parameters) {
    text += "const " + cxxType(parameter.type, home) + "& " + parameter.name + ", " + kBreak;
  }
  return text;
}

void emitStruct(Code& code, const Context& context, const model::Command& command,
                const std::string& slot) {
  const std::string& home = context.header.cxxNamespace;
  code.open("struct ", slot, " {");
  CommentedLines lines;
  for (const model::Parameter& parameter : command.parameters) {
    const bool plain = parameter.type.shape != model::Type::Shape::Enum;
    const std::string remark = plain ? parameter.unit : cxxType(parameter.type, home);
    lines.add(slotType(parameter.type, context, home) + " " + parameter.name + ";", remark);
  }
  lines.writeTo(code);
  code.close("};").blank();
}

/// What store() calls the slot, which no parameter of the command may be called as well.
std::string slotName(const model::Command& command) {
  std::string name = "slot";
  for (const model::Parameter& parameter : command.parameters) {
    if (parameter.name == name) name = "arguments_";
  }
  return name;
}

void emitStore(Code& code, const Context& context, const model::Command& command,
               const std::string& slot) {
  const std::string target = slotName(command);
  code.open("inline bool store(", parameterList(command, context.header.cxxNamespace), slot, "& ",
            target, ") {");
  code.line("using suture::store;");
  std::string call;
  for (const model::Parameter& parameter : command.parameters) {
    if (!call.empty()) call += std::string(" && ") + kBreak;
    call += "store(" + parameter.name + ", " + target + "." + parameter.name + ")";
  }
  code.line("return ", call, ";").close("}").blank();
}

template <class Declarations>
void emitNumbers(Code& code, const std::string& contract, const char* kind, const char* plural,
                 const Declarations& declarations) {
  if (declarations.empty()) return;
  code.line("/// The numbers of ", contract, "'s ", plural, ".");
  code.open("enum class ", contract, kind, " : std::uint16_t {");
  for (const auto& declaration : declarations) code.line(declaration.name, ",");
  code.close("};").blank();
}

}  // namespace

void emitArguments(Code& code, const Context& context, const model::Interface& interface) {
  const std::string& home = context.header.cxxNamespace;
  const std::string contract = prefixOf(interface);
  if (hasParameters(interface)) {
    code.line("// --- ", contract, ": the arguments of its commands ---").blank();
  }
  for (const model::Command& command : interface.commands) {
    if (command.parameters.empty()) continue;
    const std::string slot = relative(argumentsStruct(interface, command), home);
    emitStruct(code, context, command, slot);
    emitStore(code, context, command, slot);
  }
  emitNumbers(code, contract, "Command", "commands in every table and record", interface.commands);
  emitNumbers(code, contract, "Event", "events", interface.events);
}

}  // namespace suture::compiler::emit
