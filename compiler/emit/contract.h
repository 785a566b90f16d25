#pragma once
// What Required, Provided and the tables of a contract share in their spelling.

#include <string>
#include <vector>

#include "compiler/emit/code.h"
#include "compiler/emit/context.h"

namespace suture::compiler::emit {

/// kBreak, as a piece of Code::line().
inline constexpr char kBreakText[] = {kBreak, '\0'};

/// "robots::PoseStampedSlot, robots::PoseStamped": the template arguments of an Emitter or
/// Subscription.
std::string eventArguments(const Context& context, const model::Interface& interface,
                           const model::Event& event);

/// The constructor of an Events struct, which gives each event its number.
void emitEventConstructor(Code& code, const model::Interface& interface,
                          const std::string& parameter, const std::string& argument);

/// "using Id = robots::ArmCommand;" and the same for events, where there are any.
void emitNumberAliases(Code& code, const model::Interface& interface);

/// The read commands, in the order of their columns.
std::vector<const model::Command*> readsOf(const model::Interface& interface);

/// The shortest spelling of a number that reads back as the same.
std::string number(double value);

/// Where value `index` of a payload lies: "slot" for a single value, else "slot.value2".
std::string payloadMember(const model::Event& event, const std::string& slot, std::size_t index);

/// Has any command parameters?
bool hasParameters(const model::Interface& interface);

/// "servo_cp_goal".
std::string scratchName(const model::Command& command, const model::Parameter& parameter);

}  // namespace suture::compiler::emit
