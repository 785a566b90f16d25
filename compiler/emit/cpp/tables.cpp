#include "compiler/emit/cpp/levels.h"
#include "compiler/emit/cpp/stamps.h"
#include "compiler/emit/cpp/validity.h"
#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/parts.h"
#include "compiler/emit/wire/codec.h"
#include "compiler/emit/wire/wire_form.h"
#include "compiler/emit/wire/wire_places.h"
#include "compiler/model/naming.h"

#include <algorithm>
#include <sstream>
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

std::string duration(const char* name, std::int64_t nanoseconds) {
  return std::string(name) + " = suture::Duration(" + grouped(nanoseconds) + ")";
}

/// Returns the same JSON in as few lines as there have to be.
std::string packed(const std::string& json) {
  std::string text, line;
  std::istringstream lines(json);
  for (std::string one; std::getline(lines, one);) {
    one.erase(0, one.find_first_not_of(' '));
    const bool tight = line.empty() || line.ends_with('{') || line.ends_with('[') ||
                       one.starts_with('}') || one.starts_with(']');
    if (line.size() + one.size() + 1 > Code::kColumns) {
      text += line + '\n';
      line = one;
    } else {
      line += (tight ? "" : " ") + one;
    }
  }
  return text + line;
}

/// Adds the member unless there is nothing to say.
void addMember(std::vector<std::string>& members, const char* name, const std::string& value) {
  if (!value.empty()) members.push_back(std::string(name) + " = " + value);
}

/// Emits the command's row of the table; what that row needs goes to `before`.
void emitCommand(Code& table, Code& before, const Context& context,
                 const model::Interface& interface, const model::Command& command) {
  const std::string& home = context.header.cxxNamespace;
  std::vector<std::string> members = {
      ".name = \"" + command.name + "\"",
      std::string(".kind = suture::CommandKind::") + kindName(command.kind)};
  const std::string slot = relative(argumentsStruct(interface, command, context), home);
  if (!command.parameters.empty()) {
    members.push_back(".argumentsSize = suture::slotSize<" + slot + ">");
  }
  if (command.result) {
    members.push_back(".resultSize = suture::slotSize<" + slotType(*command.result, context, home) +
                      ">");
  }
  members.push_back(".depth = " + std::to_string(command.queue));
  if (command.latest) members.push_back(".latest = true");
  if (command.ttlNanoseconds) members.push_back(duration(".ttl", *command.ttlNanoseconds));
  if (command.kind == model::CommandKind::Read) {
    members.push_back(".column = " + columnName(interface, command, context));
  }
  if (command.deadlineNanoseconds) {
    members.push_back(duration(".deadline", *command.deadlineNanoseconds));
  }
  const auto isOpen = [&](const auto& carried) { return !isBounded(carried, context.lookup); };
  const auto& parameters = command.parameters;
  if (std::any_of(parameters.begin(), parameters.end(),
                  [&](const model::Parameter& one) { return isOpen(one.type); })) {
    members.push_back(".sharedArguments = true");
  }
  if (command.result && isOpen(*command.result)) members.push_back(".sharedResult = true");
  if (command.concurrent || command.direct) members.push_back(".inCallersThread = true");
  if (const std::string check = argumentsCheck(interface, command, context); !check.empty()) {
    members.push_back(".accepts = suture::checkSlot<" + slot + ", " + check + ">");
  }
  if (const std::string check = resultCheck(interface, command, context); !check.empty()) {
    members.push_back(".acceptsResult = suture::checkSlot<" +
                      slotType(*command.result, context, home) + ", " + check + ">");
  }
  addMember(members, ".shiftArguments", shiftOf(slot, argumentValues(command), context));
  const std::string name = prefixOf(interface, context) + model::titleCase(command.wireName);
  if (command.result) {
    addMember(members, ".shiftResult",
              emitShiftOf(before, *command.result, "shift" + name + "Result", context));
  }
  addMember(
      members, ".argumentsLevels",
      emitLevels(before, "k" + name + "ArgumentsLevels", slot, argumentValues(command), context));
  if (command.result) {
    addMember(members, ".resultLevels",
              emitLevels(before, "k" + name + "ResultLevels",
                         slotType(*command.result, context, home), resultValues(command), context));
  }
  emitEntry(table, members);
}

void emitCommands(Code& code, const Context& context, const model::Interface& interface) {
  if (ownCommands(interface).empty()) return;
  Code table;
  for (const model::Command* const command : ownCommands(interface)) {
    emitCommand(table, code, context, interface, *command);
  }
  code.line("constexpr suture::CommandInfo k", prefixOf(interface, context), "Commands[] = {");
  code.verbatim(table.text()).line("};").blank();
}

std::string shiftOfPayload(Code& before, const Context& context, const model::Interface& interface,
                           const model::Event& event) {
  const std::string slot = payloadSlot(interface, event, context, context.header.cxxNamespace);
  if (event.payload.size() != 1) return shiftOf(slot, payloadValues(event), context);
  const std::string name =
      "shift" + prefixOf(interface, context) + model::titleCase(event.wireName);
  return emitShiftOf(before, event.payload.front(), name + "Payload", context);
}

std::string levelsOfPayload(Code& before, const Context& context, const model::Interface& interface,
                            const model::Event& event) {
  if (event.payload.empty()) return "";
  const std::string name =
      "k" + prefixOf(interface, context) + model::titleCase(event.wireName) + "PayloadLevels";
  return emitLevels(before, name,
                    payloadSlot(interface, event, context, context.header.cxxNamespace),
                    payloadValues(event), context);
}

void emitEvents(Code& code, const Context& context, const model::Interface& interface) {
  const std::vector<const model::Event*> own = ownEvents(interface);
  if (own.empty()) return;
  Code table;
  for (const model::Event* const event : own) {
    std::vector<std::string> members = {".name = \"" + event->name + "\""};
    if (!event->payload.empty()) {
      const std::string slot = payloadSlot(interface, *event, context, context.header.cxxNamespace);
      members.push_back(".payloadSize = suture::slotSize<" + slot + ">");
    }
    members.push_back(".depth = " + std::to_string(event->queue));
    if (event->latest) members.push_back(".latest = true");
    if (event->latched) members.push_back(".latched = true");
    const auto& payload = event->payload;
    if (!std::all_of(payload.begin(), payload.end(),
                     [&](const model::Type& type) { return isBounded(type, context.lookup); })) {
      members.push_back(".sharedPayload = true");
    }
    if (const std::string check = payloadCheck(interface, *event, context); !check.empty()) {
      const std::string slot = payloadSlot(interface, *event, context, context.header.cxxNamespace);
      members.push_back(".accepts = suture::checkSlot<" + slot + ", " + check + ">");
    }
    addMember(members, ".shiftPayload", shiftOfPayload(code, context, interface, *event));
    addMember(members, ".payloadLevels", levelsOfPayload(code, context, interface, *event));
    emitEntry(table, members);
  }
  code.line("constexpr suture::EventInfo k", prefixOf(interface, context), "Events[] = {");
  code.verbatim(table.text()).line("};").blank();
}

/// Returns how kInfo spells all rows of a contract: its base has the first, its table `own` the
/// others. Emits what joins the two.
std::string rows(Code& code, const model::Interface& interface, const std::string& kind,
                 const std::string& own, std::size_t ownRows, std::size_t allRows) {
  if (ownRows == allRows) return allRows == 0 ? "{}" : own;
  std::string inherited = "interfaceInfo<" + rooted(interface.base) + ">()." + kind;
  if (ownRows == 0) return inherited;
  std::string name = "k" + model::titleCase(kind);
  code.line("static const auto ", name, " = extended<", std::to_string(allRows), ">(", kBreakText,
            inherited, ", ", kBreakText, own, ");");
  return name;
}

}  // namespace

void emitTables(Code& code, const Context& context, const model::Interface& interface) {
  emitCommands(code, context, interface);
  emitEvents(code, context, interface);
  code.line("// The self-description, as in ", model::stemOf(context.header.path), ".suture.json.");
  code.line("constexpr char k", prefixOf(interface, context), "Description[] = R\"json(");
  code.verbatim(packed(describe(context, interface))).line(")json\";").blank();
}

void emitInfo(Code& code, const Context& context, const model::Interface& interface) {
  const std::string& home = context.header.cxxNamespace;
  const std::string tables = (home.empty() ? "::k" : home + "::k") + prefixOf(interface, context);
  code.line("template <>");
  code.open("const InterfaceInfo& interfaceInfo<", rooted(interface.name), ">() {");
  const std::string commands = rows(code, interface, "commands", tables + "Commands",
                                    ownCommands(interface).size(), interface.commands.size());
  const std::string events = rows(code, interface, "events", tables + "Events",
                                  ownEvents(interface).size(), interface.events.size());
  const bool derives = !interface.base.empty();
  code.line("static ", derives ? "const" : "constexpr", " InterfaceInfo kInfo{");
  code.line("    .name = \"", interface.name, "\",");
  code.line("    .hash = \"", context.hashes.at(interface.name), "\",");
  code.line("    .description = ", tables, "Description,");
  code.line("    .commands = ", commands, ",");
  code.line("    .events = ", events, ",");
  code.line("    .codec = &", home.empty() ? "::" : home + "::", codecFunction(context, interface),
            ",");
  if (derives) {
    code.line("    .base = &interfaceInfo<", rooted(interface.base), ">,");
    code.line("    .toBase = &castToBase<", rooted(interface.name), ", ", kBreakText,
              rooted(interface.base), ">,");
  }
  if (!wireEvents(context, interface).empty()) {
    code.line("    .wireEvents = ", tables, "WireEvents,");
  }
  if (!wireColumns(context, interface).empty()) {
    code.line("    .wireColumns = ", tables, "WireColumns,");
  }
  code.line("};").line("return kInfo;").close("}").blank();
}

}  // namespace suture::compiler::emit
