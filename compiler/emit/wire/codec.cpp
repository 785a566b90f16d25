#include "compiler/emit/wire/codec.h"

#include <algorithm>
#include <set>
#include <vector>

#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/file_parts.h"
#include "compiler/emit/wire/later_parameters.h"
#include "compiler/emit/wire/wire_form.h"
#include "compiler/emit/wire/wire_places.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

std::string home(const Context& context) { return context.header.cxxNamespace; }

std::string wireInterface(const model::Interface& interface) {
  return "wire::" + interface.wireName;
}

std::string wireEventsOf(const model::Interface& interface) {
  return wireInterface(interface) + "Events";
}

std::string wireRow(const model::Interface& interface) {
  return wireInterface(interface) + "StateRow";
}

/// A Message is a slot that travels as a message, with the functions between the two.
struct Message {
  std::string name;    ///< "encode" and "decode" precede it in the functions' names
  std::string slot;    ///< the slot's type
  std::string fields;  ///< the struct of the message
  std::vector<WireValue> values;
};

/// Describes a value that every provider sends, so that a message without it is wrong.
WireValue needed(const model::Type& type, const std::string& wireName) {
  return {.type = type, .wireName = wireName, .slot = "slot", .isNeeded = true};
}

Message argumentsOf(const Context& context, const model::Interface& interface,
                    const model::Command& command) {
  const std::set<std::string> later = laterParameters(context, interface, command);
  const std::string title = model::titleCase(command.wireName);
  Message message{prefixOf(interface, context) + title,
                  relative(argumentsStruct(interface, command, context), home(context)),
                  wireInterface(interface) + "::" + title + "Params", argumentValues(command)};
  for (WireValue& value : message.values) value.isNeeded = !later.contains(value.wireName);
  return message;
}

Message resultOf(const Context& context, const model::Interface& interface,
                 const model::Command& command) {
  const std::string title = model::titleCase(command.wireName);
  return {prefixOf(interface, context) + title + "Result",
          slotType(*command.result, context, home(context)),
          wireInterface(interface) + "::" + title + "Results",
          {needed(*command.result, "value")}};
}

Message payloadOf(const Context& context, const model::Interface& interface,
                  const model::Event& event) {
  const std::set<std::string> later = laterValues(context, interface, event);
  const std::string title = model::titleCase(event.wireName);
  Message message{prefixOf(interface, context) + title + "Event",
                  payloadSlot(interface, event, context, home(context)),
                  wireEventsOf(interface) + "::" + title + "Params", payloadValues(event)};
  for (WireValue& value : message.values) value.isNeeded = !later.contains(value.wireName);
  return message;
}

bool useShift(const std::vector<WireValue>& values) {
  return std::any_of(values.begin(), values.end(),
                     [](const WireValue& one) { return usesShift(one.type); });
}

void emitMessage(Code& code, const Context& context, const Message& message) {
  code.open("void encode", message.name, "(", kBreakText, "const ", message.slot, "& slot, ",
            kBreakText, message.fields, "::Builder out) {");
  for (const WireValue& value : message.values) code.line(encode(value, "out", context), ";");
  code.close("}");
  code.open("suture::Errc decode", message.name, "(", kBreakText, message.fields, "::Reader in, ",
            kBreakText, message.slot, "& slot, ", kBreakText, "suture::Duration",
            useShift(message.values) ? " shift) {" : ") {");
  emitDecodeAndReturn(code, message.values, "in", "shift", context);
  code.close("}").blank();
}

// --- rows

/// Returns the column of a read's value, in a row.
Message columnOf(const Context& context, const model::Interface& interface,
                 const model::Command& read) {
  return {prefixOf(interface, context) + model::titleCase(read.wireName) + "Column",
          slotType(*read.result, context, home(context)),
          wireRow(interface),
          {needed(*read.result, read.wireName)}};
}

void emitEncodeColumns(Code& code, const Context& context, const model::Interface& interface) {
  code.open("void encode", prefixOf(interface, context), "Column(", kBreakText, "unsigned column, ",
            kBreakText, "const std::byte* memory, ", kBreakText, wireRow(interface),
            "::Builder out) {");
  code.open("switch (column) {");
  for (const model::Command* const read : readsOf(interface)) {
    const Message column = columnOf(context, interface, *read);
    code.choice("case " + columnName(interface, *read, context) + ":",
                "return encode" + column.name + "(" + kBreak + "suture::slotIn<" + column.slot +
                    ">(memory), " + kBreak + "out);");
  }
  code.close("}").close("}");
}

void emitDecodeColumns(Code& code, const Context& context, const model::Interface& interface) {
  code.open("suture::Errc decode", prefixOf(interface, context), "Column(", kBreakText,
            wireRow(interface), "::Reader in, ", kBreakText, "unsigned column, ", kBreakText,
            "std::byte* memory, ", kBreakText, "suture::Duration shift) {");
  code.open("switch (column) {");
  for (const model::Command* const read : readsOf(interface)) {
    const Message column = columnOf(context, interface, *read);
    code.choice("case " + columnName(interface, *read, context) + ":",
                "return decode" + column.name + "(" + kBreak + "in, " + kBreak +
                    "suture::newSlot<" + column.slot + ">(memory), " + kBreak + "shift);");
  }
  code.close("}").line("return suture::Errc::Invalid;").close("}").blank();
}

void emitRow(Code& code, const Context& context, const model::Interface& interface) {
  if (readsOf(interface).empty()) return;
  for (const model::Command* const read : readsOf(interface)) {
    emitMessage(code, context, columnOf(context, interface, *read));
  }
  code.line(
      "// A row of the state has a member for each column, so one function each way finds them "
      "all.");
  emitEncodeColumns(code, context, interface);
  emitDecodeColumns(code, context, interface);
}

// --- the tables

std::string messageOf(const Message& message) {
  return "suture::codec::messageOf<" + message.fields + ", " + kBreakText + message.slot + ", " +
         kBreakText + "encode" + message.name + ", " + kBreakText + "decode" + message.name + ">";
}

void emitCommandCodecs(Code& code, const Context& context, const model::Interface& interface) {
  const std::vector<const model::Command*> own = ownCommands(interface);
  if (own.empty()) return;
  code.line("constexpr suture::codec::CommandCodec k", prefixOf(interface, context),
            "CommandCodecs[] = {");
  for (const model::Command* const command : own) {
    const std::string method =
        wireInterface(interface) + "::" + model::titleCase(command->wireName);
    std::vector<std::string> members = {
        ".interface = capnp::typeId<" + wireInterface(interface) + ">()",
        ".method = " + std::to_string(methodOf(context, interface, *command)),
        ".sent = suture::codec::sentIn<" + method + "Params>"};
    if (!command->parameters.empty()) {
      members.push_back(".arguments = " + messageOf(argumentsOf(context, interface, *command)));
    }
    if (command->result) {
      members.push_back(".result = " + messageOf(resultOf(context, interface, *command)));
    }
    if (command->kind == model::CommandKind::Read) {
      members.push_back(".stamp = suture::codec::stampIn<" + method + "Results>");
    }
    emitEntry(code, members);
  }
  code.line("};").blank();
}

void emitEventCodecs(Code& code, const Context& context, const model::Interface& interface) {
  if (interface.events.empty()) return;
  code.line("constexpr suture::codec::EventCodec k", prefixOf(interface, context),
            "EventCodecs[] = {");
  for (const model::Event& event : interface.events) {
    std::vector<std::string> members = {
        ".method = " + std::to_string(methodOf(context, interface, event)),
        ".stamp = suture::codec::stampIn<" + wireEventsOf(interface) +
            "::" + model::titleCase(event.wireName) + "Params>"};
    if (!event.payload.empty()) {
      members.push_back(".payload = " + messageOf(payloadOf(context, interface, event)));
    }
    emitEntry(code, members);
  }
  code.line("};").blank();
}

std::string rowOf(const Context& context, const model::Interface& interface) {
  const std::string columns = prefixOf(interface, context) + "Column";
  return "suture::codec::rowOf<" + wireEventsOf(interface) + "::StateParams, " + kBreakText +
         wireRow(interface) +
         (readsOf(interface).empty() ? ">"
                                     : std::string(", ") + kBreakText + "encode" + columns + ", " +
                                           kBreakText + "decode" + columns + ">");
}

/// Returns the expression for the rows of all commands: those of the base first, then the
/// contract's own. If both have some, it emits the table that joins them.
std::string allCommands(Code& code, const Context& context, const model::Interface& interface) {
  const std::string own = "k" + prefixOf(interface, context) + "CommandCodecs";
  const std::size_t count = interface.commands.size(), owned = ownCommands(interface).size();
  if (owned == count) return count == 0 ? "{}" : own;
  const std::string inherited = "suture::interfaceInfo<" + interface.base + ">().codec().commands";
  if (owned == 0) return inherited;
  code.line("static const auto kCommands = ", kBreakText, "suture::extended<",
            std::to_string(count), ">(", kBreakText, inherited, ", ", kBreakText, own, ");");
  return "kCommands";
}

/// Emits the functions between slots and messages, and the tables that lead to them.
void emitMessages(Code& code, const Context& context, const model::Interface& interface) {
  for (const model::Command* const command : ownCommands(interface)) {
    if (!command->parameters.empty()) {
      emitMessage(code, context, argumentsOf(context, interface, *command));
    }
    if (command->result) emitMessage(code, context, resultOf(context, interface, *command));
  }
  for (const model::Event& event : interface.events) {
    if (!event.payload.empty()) emitMessage(code, context, payloadOf(context, interface, event));
  }
  emitRow(code, context, interface);
  emitCommandCodecs(code, context, interface);
  emitEventCodecs(code, context, interface);
}

}  // namespace

std::string codecFunction(const Context& context, const model::Interface& interface) {
  return model::camelCase(prefixOf(interface, context)) + "Codec";
}

void emitCodec(Code& code, const Context& context, const model::Interface& interface) {
  code.line("// --- ", prefixOf(interface, context), " as Cap'n Proto").blank();
  hidden(code, [&](Code& inner) { emitMessages(inner, context, interface); });
  code.open("const suture::codec::Codec& ", codecFunction(context, interface), "() {");
  const std::string commands = allCommands(code, context, interface);
  const bool derives = !interface.base.empty();
  code.line("static ", derives ? "const" : "constexpr", " suture::codec::Codec kCodec{");
  code.line("    .schema = suture::codec::schemaOf<", wireInterface(interface), ">,");
  code.line("    .contract = capnp::typeId<", wireInterface(interface), ">(),");
  code.line("    .subscriber = capnp::typeId<", wireEventsOf(interface), ">(),");
  code.line("    .commands = ", commands, ",");
  code.line("    .events = ",
            interface.events.empty() ? "{}" : "k" + prefixOf(interface, context) + "EventCodecs",
            ",");
  code.line("    .row = ", rowOf(context, interface), ",");
  code.line("};").line("return kCodec;").close("}").blank();
}

}  // namespace suture::compiler::emit
