#include "compiler/emit/contract.h"

#include <charconv>
#include <cmath>

#include "compiler/lock/wanted.h"

namespace suture::compiler::emit {

std::string eventArguments(const Context& context, const model::Interface& interface,
                           const model::Event& event) {
  if (event.payload.empty()) return "void";
  std::string text = payloadSlot(interface, event, context, "suture");
  for (const model::Type& type : event.payload) {
    text += std::string(", ") + kBreak + cxxType(type, "suture");
  }
  return text;
}

std::string payloadMember(const model::Event& event, const std::string& slot, std::size_t index) {
  return event.payload.size() == 1 ? slot : slot + "." + lock::payloadName(index);
}

void emitEventConstructor(Code& code, const model::Interface& interface,
                          const std::string& parameter, const std::string& argument) {
  code.line("explicit Events(", parameter, ")");
  for (const model::Event& event : interface.events) {
    const bool first = &event == &interface.events.front();
    const bool last = &event == &interface.events.back();
    code.line(first ? "    : " : "      ", event.name, "{", argument,
              ", static_cast<std::uint16_t>(EventId::", event.name, ")}", last ? " {}" : ",");
  }
}

void emitNumberAliases(Code& code, const model::Interface& interface) {
  if (!interface.commands.empty()) code.line("using Id = ", interface.name, "Command;");
  if (!interface.events.empty()) code.line("using EventId = ", interface.name, "Event;");
}

std::vector<const model::Command*> readsOf(const model::Interface& interface) {
  std::vector<const model::Command*> reads;
  for (const model::Command& command : interface.commands) {
    if (command.kind == model::CommandKind::Read) reads.push_back(&command);
  }
  return reads;
}

std::string number(double value) {
  char text[64];
  char* end = std::to_chars(text, text + sizeof text, value).ptr;
  const bool everyday = std::abs(value) >= 1e-6 && std::abs(value) < 1e9;
  if (everyday) end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed).ptr;
  return {text, end};
}

bool hasParameters(const model::Interface& interface) {
  for (const model::Command& command : interface.commands) {
    if (!command.parameters.empty()) return true;
  }
  return false;
}

std::string scratchName(const model::Command& command, const model::Parameter& parameter) {
  return command.name + "_" + parameter.name;
}

}  // namespace suture::compiler::emit
