#include <utility>

#include "compiler/emit/cpp/stamps.h"
#include "compiler/emit/text/contract.h"
#include "compiler/emit/text/parts.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

/// Names a parameter's value within store(). That calls other functions of its name, which a
/// parameter called "store" would hide.
std::string valueName(const model::Command& command, const model::Parameter& parameter) {
  return parameter.name == "store" ? freeName("store", command.parameters) : parameter.name;
}

/// Returns "const PoseStamped& goal, const double& time, ".
std::string parameterList(const model::Command& command, const std::string& home) {
  std::string text;
  for (const model::Parameter& parameter : command.parameters) {
    text += "const " + cxxType(parameter.type, home) + "& " + valueName(command, parameter) + ", " +
            kBreak;
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

/// Returns a name for the slot in store() that no parameter of the command has.
std::string slotName(const model::Command& command) { return freeName("slot", command.parameters); }

std::string storeSignature(const Context& context, const model::Command& command,
                           const std::string& slot) {
  return "bool store(" + parameterList(command, context.header.cxxNamespace) + slot + "& " +
         slotName(command) + ")";
}

void emitStore(Code& code, const Context& context, const model::Command& command,
               const std::string& slot) {
  std::string call;
  for (const model::Parameter& parameter : command.parameters) {
    if (!call.empty()) call += std::string(" && ") + kBreak;
    call += "store(" + valueName(command, parameter) + ", " + slotName(command) + "." +
            parameter.name + ")";
  }
  code.function(storeSignature(context, command, slot), "return " + call + ";").blank();
}

/// Spells the slot for several values of an event, and the functions on it.
struct Payload {
  Payload(const Context& context, const model::Interface& interface, const model::Event& event)
      : slot(payloadSlot(interface, event, context, context.header.cxxNamespace)) {
    std::string constants, variables, grown;
    for (std::size_t i = 0; i < event.payload.size(); ++i) {
      const std::string type = cxxType(event.payload[i], context.header.cxxNamespace);
      constants += "const " + type + "& " + lock::payloadName(i) + ", " + kBreak;
      const std::string variable = std::string(", ") + kBreak + type + "& ";
      const bool grows = emit::reserves(event.payload[i], context.lookup);
      variables += variable + lock::payloadName(i);
      grown += variable + named(lock::payloadName(i).c_str(), grows);
      reserves = reserves || grows;
    }
    store = "bool store(" + constants + slot + "& slot)";
    load = "void load(const " + slot + "& slot" + variables + ")";
    reserve = "void reserve(const " + slot + "*" + grown + ")";
  }
  std::string slot, store, load, reserve;
  bool reserves = false;
};

void declarePayload(Code& code, const Context& context, const model::Interface& interface,
                    const model::Event& event) {
  const Payload payload(context, interface, event);
  code.open("struct ", payload.slot, " {");
  for (std::size_t i = 0; i < event.payload.size(); ++i) {
    code.line(slotType(event.payload[i], context, context.header.cxxNamespace), " ",
              lock::payloadName(i), ";");
  }
  code.close("};").blank();
  code.line(payload.store, ";").line(payload.load, ";");
  if (payload.reserves) code.line(payload.reserve, ";");
  declareShift(code, payloadValues(event), payload.slot, context);
  code.blank();
}

void emitReserve(Code& code, const Context& context, const model::Event& event,
                 const Payload& payload) {
  code.open(payload.reserve, " {");
  for (std::size_t i = 0; i < event.payload.size(); ++i) {
    const std::string name = lock::payloadName(i);
    if (!reserves(event.payload[i], context.lookup)) continue;
    code.line("suture::reserveFor<decltype(", payload.slot, "::", name, ")>(", name, ");");
  }
  code.close("}").blank();
}

void emitPayload(Code& code, const Context& context, const model::Interface& interface,
                 const model::Event& event) {
  const Payload payload(context, interface, event);
  std::string stores;
  for (std::size_t i = 0; i < event.payload.size(); ++i) {
    const std::string name = lock::payloadName(i);
    stores +=
        (i == 0 ? "" : std::string(" && ") + kBreak) + "store(" + name + ", slot." + name + ")";
  }
  code.function(payload.store, "return " + stores + ";").blank();
  code.open(payload.load, " {");
  for (std::size_t i = 0; i < event.payload.size(); ++i) {
    code.line("load(slot.", lock::payloadName(i), ", ", lock::payloadName(i), ");");
  }
  code.close("}").blank();
  if (payload.reserves) emitReserve(code, context, event, payload);
  emitShift(code, payloadValues(event), payload.slot, context);
}

/// Calls `emit` for each command that has a slot of its own for its parameters.
template <class Emit>
void forEachArguments(const Context& context, const model::Interface& interface, const Emit& emit) {
  for (const model::Command& command : interface.commands) {
    if (command.parameters.empty() || !command.inheritedFrom.empty()) continue;
    emit(command,
         relative(argumentsStruct(interface, command, context), context.header.cxxNamespace));
  }
}

/// Calls `emit` for each event of several values, which have a slot of their own together.
template <class Emit>
void forEachPayload(const model::Interface& interface, const Emit& emit) {
  for (const model::Event& event : interface.events) {
    if (event.payload.size() >= 2 && event.inheritedFrom.empty()) emit(event);
  }
}

/// Emits the numbers of what the contract declares itself, which follow those of what it inherits.
/// They are members of a struct and not enumerators, because clang warns of an enumerator that
/// hides a name in the user's namespace.
template <class Declarations>
void emitNumbers(Code& code, const std::string& contract, const char* kind, const std::string& doc,
                 const Declarations& own, std::size_t inherited) {
  if (own.empty()) return;
  code.line("/// Numbers ", doc, ".");
  code.open("struct ", contract, kind, " {");
  for (const auto* const declaration : own) {
    code.line("static constexpr std::uint16_t ", declaration->name, " = ",
              std::to_string(inherited++), ";");
  }
  code.close("};").blank();
}

/// Returns "the events of Arm", and ", behind those that it inherits" if there are such.
std::string numbered(const std::string& contract, const char* plural, std::size_t inherited) {
  return std::string("the ") + plural + " of " + contract +
         (inherited == 0 ? "" : ", behind those that it inherits");
}

}  // namespace

void emitArguments(Code& code, const Context& context, const model::Interface& interface) {
  const std::string contract = prefixOf(interface, context);
  std::string title = ": the arguments of its commands ---";
  const auto titled = [&] {
    if (!title.empty()) code.line("// --- ", contract, std::exchange(title, "")).blank();
  };
  forEachArguments(context, interface, [&](const model::Command& command, const std::string& slot) {
    titled();
    emitStruct(code, context, command, slot);
    code.line(storeSignature(context, command, slot), ";");
    declareShift(code, argumentValues(command), slot, context);
    code.blank();
  });
  title = ": what its events carry ---";
  forEachPayload(interface, [&](const model::Event& event) {
    titled();
    declarePayload(code, context, interface, event);
  });
  const auto commands = ownCommands(interface);
  const std::size_t otherCommands = interface.commands.size() - commands.size();
  emitNumbers(code, contract, "Command", numbered(contract, "commands", otherCommands), commands,
              otherCommands);
  const auto events = ownEvents(interface);
  const std::size_t otherEvents = interface.events.size() - events.size();
  emitNumbers(code, contract, "Event", numbered(contract, "events", otherEvents), events,
              otherEvents);
  emitNumbers(code, contract, "Column",
              "the reads of " + contract + " as a row of the state has them", readsOf(interface),
              0);
}

void emitArgumentConversions(Code& code, const Context& context,
                             const model::Interface& interface) {
  forEachArguments(context, interface, [&](const model::Command& command, const std::string& slot) {
    emitStore(code, context, command, slot);
    emitShift(code, argumentValues(command), slot, context);
  });
  forEachPayload(interface,
                 [&](const model::Event& event) { emitPayload(code, context, interface, event); });
}

}  // namespace suture::compiler::emit
