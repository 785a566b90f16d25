#pragma once
// This says what generated C++ calls the things that it declares for those of a header.

#include <string>

#include "compiler/model/lookup.h"
#include "compiler/model/model.h"

namespace suture::compiler::model {

/// Returns how the names of all that is generated for a declaration begin, in its header's
/// namespace: "robots::ArmState" for "robots::Arm::State", "robots::msgsPose" for "msgs::Pose".
std::string generatedName(const std::string& declared, const Lookup& lookup);

/// Turns "servo_cp" into "ServoCp": a part of the name of something generated.
std::string pascalCase(const std::string& cxxName);

/// Names the slot of a command's parameters, of the contract that declares it:
/// "robots::ArmServoCpArguments".
std::string argumentsStruct(const Interface& interface, const Command& command,
                            const Lookup& lookup);

/// Names the slot of several values of an event in the same way: "robots::ArmMovedPayload".
std::string payloadStruct(const Interface& interface, const Event& event, const Lookup& lookup);

}  // namespace suture::compiler::model
