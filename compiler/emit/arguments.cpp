#include <utility>

#include "compiler/emit/contract.h"
#include "compiler/emit/parts.h"
#include "compiler/lock/wanted.h"
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

/// The slot of several values, its store() and its load().
void emitPayload(Code& code, const Context& context, const model::Interface& interface,
                 const model::Event& event) {
  const std::string& home = context.header.cxxNamespace;
  const std::string slot = payloadSlot(interface, event, context, home);
  code.open("struct ", slot, " {");
  std::string constants, variables, stores;
  for (std::size_t i = 0; i < event.payload.size(); ++i) {
    const std::string type = cxxType(event.payload[i], home);
    const std::string name = lock::payloadName(i);
    code.line(slotType(event.payload[i], context, home), " ", name, ";");
    constants += "const " + type + "& " + name + ", " + kBreak;
    variables += std::string(", ") + kBreak + type + "& " + name;
    stores +=
        (i == 0 ? "" : std::string(" && ") + kBreak) + "store(" + name + ", slot." + name + ")";
  }
  code.close("};").blank();
  code.open("inline bool store(", constants, slot, "& slot) {").line("using suture::store;");
  code.line("return ", stores, ";").close("}").blank();
  code.open("inline void load(const ", slot, "& slot", variables, ") {")
      .line("using suture::load;");
  for (std::size_t i = 0; i < event.payload.size(); ++i) {
    code.line("load(slot.", lock::payloadName(i), ", ", lock::payloadName(i), ");");
  }
  code.close("}").blank();
}

void emitPayloads(Code& code, const Context& context, const model::Interface& interface) {
  bool first = true;
  for (const model::Event& event : interface.events) {
    if (event.payload.size() < 2 || !event.inheritedFrom.empty()) continue;
    if (first) code.line("// --- ", prefixOf(interface), ": what its events carry ---").blank();
    first = false;
    emitPayload(code, context, interface, event);
  }
}

template <class Declarations>
void emitNumbers(Code& code, const std::string& contract, const char* kind, const char* plural,
                 const Declarations& own, std::size_t all) {
  if (own.empty()) return;
  std::size_t inherited = all - own.size();
  const char* const whose = inherited == 0 ? "" : "own ";
  code.line("/// The numbers of ", contract, "'s ", whose, plural, ".");
  code.open("enum class ", contract, kind, " : std::uint16_t {");
  for (const auto* const declaration : own) {
    code.line(declaration->name, startOf(std::exchange(inherited, 0)), ",");
  }
  code.close("};").blank();
}

}  // namespace

void emitArguments(Code& code, const Context& context, const model::Interface& interface) {
  const std::string& home = context.header.cxxNamespace;
  const std::string contract = prefixOf(interface);
  bool first = true;
  for (const model::Command& command : interface.commands) {
    if (command.parameters.empty() || !command.inheritedFrom.empty()) continue;
    if (first) code.line("// --- ", contract, ": the arguments of its commands ---").blank();
    first = false;
    const std::string slot = relative(argumentsStruct(interface, command), home);
    emitStruct(code, context, command, slot);
    emitStore(code, context, command, slot);
  }
  emitPayloads(code, context, interface);
  emitNumbers(code, contract, "Command", "commands in every table and record",
              ownCommands(interface), interface.commands.size());
  emitNumbers(code, contract, "Event", "events", ownEvents(interface), interface.events.size());
}

}  // namespace suture::compiler::emit
