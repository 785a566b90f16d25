#include "compiler/emit/contract.h"
#include "compiler/emit/parts.h"
#include "compiler/emit/remote.h"
#include "compiler/model/naming.h"

#include <vector>

namespace suture::compiler::emit {
namespace {

const char* kindName(model::CommandKind kind) {
  switch (kind) {
    case model::CommandKind::Void: return "Void";
    case model::CommandKind::Write: return "Write";
    case model::CommandKind::Read: return "Read";
    case model::CommandKind::QualifiedRead: return "QualifiedRead";
    case model::CommandKind::VoidReturn: return "VoidReturn";
    case model::CommandKind::WriteReturn: return "WriteReturn";
  }
  return "";
}

std::string flag(const char* name, bool value) {
  return std::string(name) + (value ? " = true" : " = false");
}

/// One row of a table: on one line if it fits, else one member a line.
void emitEntry(Code& code, const std::vector<std::string>& members) {
  std::string row;
  for (const std::string& member : members) row += (row.empty() ? "    {" : ", ") + member;
  if (row.size() + 2 <= Code::kColumns) {
    code.line(row, "},");
    return;
  }
  for (const std::string& member : members) {
    const bool first = &member == &members.front();
    const bool last = &member == &members.back();
    code.line(first ? "    {" : "     ", member, last ? "}," : ",");
  }
}

void emitCommand(Code& code, const Context& context, const model::Interface& interface,
                 const model::Command& command, int column) {
  const std::string& home = context.header.cxxNamespace;
  const std::string arguments =
      command.parameters.empty()
          ? "0"
          : "sizeof(" + relative(argumentsStruct(interface, command), home) + ")";
  const std::string result =
      command.result ? "sizeof(" + slotType(*command.result, context, home) + ")" : "0";
  std::vector<std::string> members = {
      ".name = \"" + command.name + "\"",
      std::string(".kind = CommandKind::") + kindName(command.kind),
      ".argumentsSize = " + arguments,
      ".resultSize = " + result,
      ".depth = " + std::to_string(command.queue),
      flag(".latest", command.latest),
      ".ttl = Duration(" + grouped(command.ttlNanoseconds.value_or(0)) + ")",
      ".column = " + std::to_string(column)};
  if (command.deadlineNanoseconds) {
    members.push_back(".deadline = Duration(" + grouped(*command.deadlineNanoseconds) + ")");
  }
  emitEntry(code, members);
}

void emitCommands(Code& code, const Context& context, const model::Interface& interface) {
  if (interface.commands.empty()) return;
  code.line("constexpr CommandInfo k", prefixOf(interface), "Commands[] = {");
  int columns = 0;
  for (const model::Command& command : interface.commands) {
    const bool read = command.kind == model::CommandKind::Read;
    emitCommand(code, context, interface, command, read ? columns++ : -1);
  }
  code.line("};").blank();
}

void emitEvents(Code& code, const Context& context, const model::Interface& interface) {
  if (interface.events.empty()) return;
  code.line("constexpr EventInfo k", prefixOf(interface), "Events[] = {");
  for (const model::Event& event : interface.events) {
    const std::string size =
        event.payload.empty()
            ? "0"
            : "sizeof(" + payloadSlot(interface, event, context, context.header.cxxNamespace) + ")";
    emitEntry(code, {".name = \"" + event.name + "\"", ".payloadSize = " + size,
                     ".depth = " + std::to_string(event.queue), flag(".latest", event.latest),
                     flag(".latched", event.latched)});
  }
  code.line("};").blank();
}

}  // namespace

void emitTables(Code& code, const Context& context, const model::Interface& interface) {
  emitCommands(code, context, interface);
  emitEvents(code, context, interface);
  code.line("// The self-description, as in ", model::stemOf(context.header.path), ".suture.json.");
  code.line("constexpr char k", prefixOf(interface), "Description[] = R\"json(",
            describe(context, interface), ")json\";");
  code.blank();
}

void emitInfo(Code& code, const Context& context, const model::Interface& interface) {
  const std::string& home = context.header.cxxNamespace;
  const std::string tables = (home.empty() ? "::k" : home + "::k") + prefixOf(interface);
  code.line("template <>");
  code.open("const InterfaceInfo& interfaceInfo<", interface.name, ">() {");
  code.line("static constexpr InterfaceInfo kInfo{");
  code.line("    .name = \"", interface.name, "\",");
  code.line("    .hash = \"", context.hashes.at(interface.name), "\",");
  code.line("    .description = ", tables, "Description,");
  code.line("    .commands = ", interface.commands.empty() ? "{}" : tables + "Commands", ",");
  code.line("    .events = ", interface.events.empty() ? "{}" : tables + "Events", ",");
  code.line("    .binding = &", home.empty() ? "::" : home + "::", bindingFunction(interface), ",");
  if (!interface.base.empty()) {
    code.line("    .base = &interfaceInfo<", interface.base, ">,");
    code.line("    .toBase = &castToBase<", interface.name, ", ", kBreakText, interface.base, ">,");
  }
  code.line("};").line("return kInfo;").close("}").blank();
}

}  // namespace suture::compiler::emit
