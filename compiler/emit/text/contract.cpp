#include "compiler/emit/text/contract.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string>

#include "compiler/lock/schema/wanted.h"

namespace suture::compiler::emit {

std::string eventArguments(const Context& context, const model::Interface& interface,
                           const model::Event& event, const MemberNames& names) {
  if (event.payload.empty()) return "void";
  std::string text = names.spell(payloadSlot(interface, event, context, "suture"));
  for (const model::Type& type : event.payload) {
    text += std::string(", ") + kBreak + names.spell(cxxType(type, "suture"));
  }
  return text;
}

std::string payloadMember(const model::Event& event, const std::string& slot, std::size_t index) {
  return event.payload.size() == 1 ? slot : slot + "." + lock::payloadName(index);
}

std::string baseClass(const char* kind, const model::Interface& interface) {
  if (interface.base.empty()) return std::string(kind) + "Base";
  return std::string(kind) + "<" + rooted(interface.base) + ">";
}

void emitEventsHead(Code& code, const model::Interface& interface, const std::string& base) {
  const bool inherits = ownEvents(interface).size() < interface.events.size();
  code.open("struct Events ", inherits ? ": " + base + "::Events " : "", "{");
}

void emitEventConstructor(Code& code, const model::Interface& interface, const std::string& base,
                          const std::string& parameter, const std::string& argument) {
  const std::vector<const model::Event*> events = ownEvents(interface);
  code.line("explicit Events(", parameter, ")");
  const char* lead = "    : ";
  if (events.size() < interface.events.size()) {
    code.line(lead, base, "::Events(", argument, "),");
    lead = "      ";
  }
  for (const model::Event* const event : events) {
    code.line(lead, event->name, "{", argument, ", ", kBreakText, "EventId::", event->name, "}",
              event == events.back() ? " {}" : ",");
    lead = "      ";
  }
}

void emitNumberAliases(Code& code, const Context& context, const model::Interface& interface) {
  const std::string name = rooted(generatedName(interface.name, context.lookup));
  if (!ownCommands(interface).empty()) code.line("using Id = ", name, "Command;");
  if (!ownEvents(interface).empty()) code.line("using EventId = ", name, "Event;");
}

namespace {

template <class Declaration>
std::vector<const Declaration*> ownOf(const std::vector<Declaration>& all) {
  std::vector<const Declaration*> own;
  for (const Declaration& one : all) {
    if (one.inheritedFrom.empty()) own.push_back(&one);
  }
  return own;
}

}  // namespace

std::vector<const model::Command*> ownCommands(const model::Interface& interface) {
  return ownOf(interface.commands);
}

std::vector<const model::Event*> ownEvents(const model::Interface& interface) {
  return ownOf(interface.events);
}

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

std::vector<const model::Command*> readsOf(const model::Interface& interface) {
  std::vector<const model::Command*> reads;
  for (const model::Command& command : interface.commands) {
    if (command.kind == model::CommandKind::Read) reads.push_back(&command);
  }
  return reads;
}

std::string columnName(const model::Interface& interface, const model::Command& read,
                       const Context& context) {
  return prefixOf(interface, context) + "Column::" + read.name;
}

std::string number(double value) {
  char text[64];
  char* end = std::to_chars(text, text + sizeof text, value).ptr;
  const bool everyday = std::abs(value) >= 1e-6 && std::abs(value) < 1e9;
  if (everyday) end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed).ptr;
  return {text, end};
}

std::string cxxNumber(double value) {
  const std::string infinity = "std::numeric_limits<double>::infinity()";
  if (std::isinf(value)) return (value < 0 ? "-" : "") + infinity;
  const std::string text = number(value);
  // Such an integer fits no type of C++.
  const bool large = std::abs(value) >= 0x1p63 && text.find_first_of(".e") == std::string::npos;
  return large ? text + ".0" : text;
}

bool hasOwnParameters(const model::Interface& interface) {
  for (const model::Command* const command : ownCommands(interface)) {
    if (!command->parameters.empty()) return true;
  }
  return false;
}

namespace {

/// Looks into each struct once.
class Reserves {
 public:
  explicit Reserves(const model::Lookup& lookup) : lookup_(lookup) {}

  bool any(const model::Struct& declaration) {
    if (!seen_.insert(declaration.name).second) return false;
    return std::any_of(declaration.fields.begin(), declaration.fields.end(),
                       [this](const model::Field& field) { return any(field.type); });
  }

  bool any(const model::Type& type) {
    using Shape = model::Type::Shape;
    switch (type.shape) {
      case Shape::Text: return type.capacity.value_or(0) > 0;
      case Shape::List:  // not of sets, deques and Eigen's vectors, which cannot
        return type.capacity.value_or(0) > 0 && type.spelling.starts_with("std::vector<");
      case Shape::Array: return any(type.element.front());
      case Shape::Struct: {
        const model::Struct* const declaration = lookup_.findStruct(type.name);
        return declaration != nullptr && any(*declaration);
      }
      default: return false;
    }
  }

 private:
  const model::Lookup& lookup_;
  std::set<std::string> seen_;
};

}  // namespace

bool reserves(const model::Struct& declaration, const model::Lookup& lookup) {
  return Reserves(lookup).any(declaration);
}

bool reserves(const model::Type& type, const model::Lookup& lookup) {
  return Reserves(lookup).any(type);
}

std::vector<Argument> reservedArguments(const model::Interface& interface,
                                        const model::Lookup& lookup) {
  std::vector<Argument> arguments;
  for (const model::Command* const command : ownCommands(interface)) {
    for (const model::Parameter& parameter : command->parameters) {
      if (reserves(parameter.type, lookup)) arguments.push_back({*command, parameter});
    }
  }
  return arguments;
}

std::string named(const char* name, bool used) {
  return used ? name : std::string("/*") + name + "*/";
}

std::string scratchName(const model::Interface& interface, const model::Command& command,
                        const model::Parameter& parameter) {
  const std::string name = command.name + "_" + parameter.name;
  for (const model::Command* const other : ownCommands(interface)) {
    if (other->name == command.name) continue;
    for (const model::Parameter& one : other->parameters) {
      if (other->name + "_" + one.name == name) return name + "_of_" + command.name;
    }
  }
  return name;
}

std::string methodPointer(const model::Command& command, const MemberNames& names) {
  const std::string plain = "&Contract::" + command.name;
  if (!command.isOverloaded) return plain;
  const auto spelled = [&](const model::Type& type, bool byReference) {
    const std::string text = names.spell(cxxType(type, "suture"));
    return byReference ? "const " + text + "&" : text;
  };
  std::string parameters;
  for (const model::Parameter& one : command.parameters) {
    if (!parameters.empty()) parameters += std::string(", ") + kBreak;
    parameters += spelled(one.type, one.byReference);
  }
  const bool isConst =
      command.kind == model::CommandKind::Read || command.kind == model::CommandKind::QualifiedRead;
  return "static_cast<" +
         (command.result ? spelled(*command.result, command.resultByReference) : "void") +
         " (Contract::*)(" + parameters + ")" + (isConst ? " const" : "") + ">(" + plain + ")";
}

}  // namespace suture::compiler::emit
