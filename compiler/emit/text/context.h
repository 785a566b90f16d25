#pragma once
// What every emitter of one header needs: the model around it, and how names are spelled in
// generated C++.

#include <map>
#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/model/lookup.h"
#include "compiler/model/model.h"

namespace suture::compiler::emit {

struct Context {
  const model::Model& model;
  const model::Lookup& lookup;
  const lock::Locks& locks;
  const std::map<std::string, lock::Lock>& schemas;  ///< `locks` as an update would leave them
  const std::map<std::string, std::string>& hashes;  ///< by contract, see lock/contract_hash.h
  const std::map<std::string, std::string>& cores;   ///< the same without optional commands
  const model::Header& header;                       ///< the one being written
};

/// "robots::arm::Pose" -> "Pose" within namespace "robots::arm"; unchanged elsewhere.
std::string relative(const std::string& name, const std::string& inNamespace);

/// Begins the names of all that is generated for a declaration, in its header's namespace:
/// "robots::ArmState" for "robots::Arm::State", "robots::msgsPose" for "msgs::Pose".
std::string generatedName(const std::string& declared, const model::Lookup& lookup);

/// The slot struct of a SUTURE_TYPE, qualified: "robots::PoseStampedSlot".
std::string slotStruct(const std::string& structName, const model::Lookup& lookup);

/// The type of a value's slot: "std::array<double, 12>", spelled as within namespace `inNamespace`.
std::string slotType(const model::Type& type, const Context& context,
                     const std::string& inNamespace);

/// The C++ type itself, spelled as within namespace `inNamespace`.
std::string cxxType(const model::Type& type, const std::string& inNamespace);

/// "std::int32_t".
std::string cxxScalar(model::Scalar scalar);

/// What a list or a map has in its slot, one each.
std::string elementSlot(const model::Type& type, const Context& context,
                        const std::string& inNamespace);

/// How a field of `object`, an lvalue called so, is reached from namespace `inNamespace`; of a
/// packed field a copy.
std::string access(const model::Struct& owner, const model::Field& field, const std::string& object,
                   bool isConst, const std::string& inNamespace);

/// A statement that changes a field of `value`, spelled as within namespace `inNamespace`: `before`
/// and `after` stand around the field.
std::string changeField(const model::Struct& owner, const model::Field& field,
                        const std::string& before, const std::string& after,
                        const std::string& inNamespace);

/// False if some level in it has no capacity, or it holds itself: then its slot owns memory.
bool isBounded(const model::Type& type, const model::Lookup& lookup);
/// Does it hold one of its own kind, however deep?
bool isRecursive(const model::Struct& declaration, const model::Lookup& lookup);
/// Is it an optional value of such a type?
bool holdsRecursive(const model::Type& type, const model::Lookup& lookup);

/// "servo_cp" -> "ServoCp": a part of the name of something generated.
std::string pascalCase(const std::string& cxxName);

/// The unqualified name that begins the names of what is generated for a contract.
std::string prefixOf(const model::Interface& interface, const Context& context);

/// "robots::ArmServoCpArguments": the slot of a command's parameters, of the contract that declares
/// it.
std::string argumentsStruct(const model::Interface& interface, const model::Command& command,
                            const Context& context);

/// The slot of an event's payload: the value's own, or "robots::ArmMovedPayload" when it has
/// several. Spelled as within namespace `inNamespace`.
std::string payloadSlot(const model::Interface& interface, const model::Event& event,
                        const Context& context, const std::string& inNamespace);

/// "namespace robots {", or nothing at global scope; and its end.
std::string openNamespace(const std::string& name);
std::string closeNamespace(const std::string& name);

/// "// Written by suturec from arm/arm.h. Do not edit.\n".
std::string banner(const model::Header& header);

/// "50'000'000": a number as people group it in C++.
std::string grouped(std::int64_t number);

/// The value of an enumerator, as people read it: "18446744073709551615".
std::string valueText(const model::Enum& type, const model::Enumerator& enumerator);

/// The same as a C++ constant of the underlying type: "18'446'744'073'709'551'615u".
std::string valueLiteral(const model::Enum& type, const model::Enumerator& enumerator);

}  // namespace suture::compiler::emit
