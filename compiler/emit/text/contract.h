#pragma once
// Required, Provided and the tables of a contract share this spelling.

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/context.h"
#include "compiler/emit/text/member_names.h"

namespace suture::compiler::emit {

/// This is kBreak as a piece of Code::line().
inline constexpr char kBreakText[] = {kBreak, '\0'};

/// Returns the template arguments of an Emitter or Subscription: "robots::PoseStampedSlot,
/// robots::PoseStamped".
std::string eventArguments(const Context& context, const model::Interface& interface,
                           const model::Event& event, const MemberNames& names);

/// Returns "Required<robots::Arm>" for "Required" and a contract that derives from Arm;
/// "RequiredBase" where it derives from none.
std::string baseClass(const char* kind, const model::Interface& interface);

/// Opens "struct Events {", with the base's Events where it has inherited ones.
void emitEventsHead(Code& code, const model::Interface& interface, const std::string& base);

/// Emits the constructor of an Events struct, which gives each event its number. `base` is the
/// class whose Events has those that the contract inherits.
void emitEventConstructor(Code& code, const model::Interface& interface, const std::string& base,
                          const std::string& parameter, const std::string& argument);

/// Emits "using Id = robots::ArmCommand;" and the same for events, where it adds any.
void emitNumberAliases(Code& code, const Context& context, const model::Interface& interface);

/// Returns what the contract declares itself. For the rest its code calls that of its base, whose
/// commands and events come first among its own.
std::vector<const model::Command*> ownCommands(const model::Interface& interface);
std::vector<const model::Event*> ownEvents(const model::Interface& interface);

/// Emits a row of a table: on one line if it fits, else one member a line.
void emitEntry(Code& code, const std::vector<std::string>& members);

/// Returns the read commands, in the order of their columns.
std::vector<const model::Command*> readsOf(const model::Interface& interface);

/// Returns "ArmColumn::measured_cp": the place of a read's value in a row.
std::string columnName(const model::Interface& interface, const model::Command& read,
                       const Context& context);

/// Returns the shortest spelling of a number that reads back as the same.
std::string number(double value);
/// Does the same as C++ spells it.
std::string cxxNumber(double value);

/// Says where value `index` of a payload lies: "slot" for a single value, else "slot.value2".
std::string payloadMember(const model::Event& event, const std::string& slot, std::size_t index);

/// Tells if any command that the contract declares itself has parameters.
bool hasOwnParameters(const model::Interface& interface);

/// Returns true if a value of the type takes its memory once, for its largest content: then
/// reserve() of runtime/base gives it that.
bool reserves(const model::Type& type, const model::Lookup& lookup);
bool reserves(const model::Struct& declaration, const model::Lookup& lookup);

/// An Argument is a parameter for which reserves() is true, with its command, which the contract
/// declares itself.
struct Argument {
  const model::Command& command;
  const model::Parameter& parameter;
};
std::vector<Argument> reservedArguments(const model::Interface& interface,
                                        const model::Lookup& lookup);

/// Returns a parameter's name, in a comment where nothing uses it.
std::string named(const char* name, bool used);

/// Returns a name for a parameter that is the name of none of the declarations.
template <class Declaration>
std::string freeName(std::string name, const std::vector<Declaration>& declarations) {
  const auto isTaken = [&](const Declaration& one) { return one.name == name; };
  while (std::any_of(declarations.begin(), declarations.end(), isTaken)) name += "Given";
  return name;
}

/// Returns "servo_cp_goal", or if another command that the contract declares has a parameter which
/// reads so, "servo_cp_goal_of_servo_cp".
std::string scratchName(const model::Interface& interface, const model::Command& command,
                        const model::Parameter& parameter);

/// Returns "&Contract::servo_cp", with its type if the contract has other methods of that name.
std::string methodPointer(const model::Command& command, const MemberNames& names);

}  // namespace suture::compiler::emit
