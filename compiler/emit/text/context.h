#pragma once
// This is what every emitter of one header needs: the model around it, and how names are spelled in
// generated C++.

#include <map>
#include <string>
#include <vector>

#include "compiler/lock/parts.h"
#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/node_index.h"
#include "compiler/model/generated_names.h"
#include "compiler/model/lookup.h"
#include "compiler/model/model.h"

namespace suture::compiler::emit {

using model::generatedName;
using model::pascalCase;

struct Context {
  const model::Model& model;
  const model::Lookup& lookup;
  const lock::Locks& locks;
  const lock::NodeIndexes& schemas;                  ///< `locks` as an update would leave them
  const std::map<std::string, std::string>& hashes;  ///< each contract's, see lock/contract_hash.h
  const std::map<std::string, std::string>& cores;   ///< the same without optional commands
  const model::Header& header;                       ///< the one being written, or a share of it
  const lock::Parts* parts = nullptr;  ///< those that its schema is split into, if it is
  unsigned share = 0;                  ///< the first has components and readers too
};

/// Turns "robots::arm::Pose" into "Pose" within namespace "robots::arm"; elsewhere it is unchanged.
std::string relative(const std::string& name, const std::string& inNamespace);

/// Returns the name as C++ finds it from any namespace: "::Sample" of what is in none, since the
/// runtime has a Sample as well. The namespace is said where a class is around the declaration.
std::string rooted(const std::string& name);
std::string rooted(const std::string& name, const std::string& itsNamespace);

/// Returns the namespace that the struct is in.
std::string namespaceOf(const model::Struct& declaration, const Context& context);

/// Names the slot struct of a SUTURE_TYPE, qualified: "robots::PoseStampedSlot".
std::string slotStruct(const std::string& structName, const model::Lookup& lookup);

/// Returns the type of a value's slot: "std::array<double, 12>", spelled as within namespace
/// `inNamespace`.
std::string slotType(const model::Type& type, const Context& context,
                     const std::string& inNamespace);

/// Returns the C++ type itself, spelled as within namespace `inNamespace`.
std::string cxxType(const model::Type& type, const std::string& inNamespace);

/// Returns "std::int32_t".
std::string cxxScalar(model::Scalar scalar);

/// Returns the slot type of one element of a list or a map.
std::string elementSlot(const model::Type& type, const Context& context,
                        const std::string& inNamespace);

/// Says how a field of `object`, an lvalue called so, is reached from namespace `inNamespace`; for
/// a packed field that is a copy.
std::string access(const model::Struct& owner, const model::Field& field, const std::string& object,
                   bool isConst, const std::string& inNamespace);

/// Returns a statement that changes a field of `value`, spelled as within namespace `inNamespace`:
/// `before` and `after` stand around the field.
std::string changeField(const model::Struct& owner, const model::Field& field,
                        const std::string& before, const std::string& after,
                        const std::string& inNamespace);

/// Returns false if some level in it has no capacity, or it holds itself: then its slot owns
/// memory.
bool isBounded(const model::Type& type, const model::Lookup& lookup);
/// Tells if it holds one of its own kind, however deep.
bool isRecursive(const model::Struct& declaration, const model::Lookup& lookup);
/// Tells if it is an optional value of such a type.
bool holdsRecursive(const model::Type& type, const model::Lookup& lookup);

/// Returns "robots::types::", which stands in front of a function for a type of another namespace
/// than the header's.
std::string qualifier(const std::string& declared, const Context& context);

/// Returns the unqualified name that begins the names of what is generated for a contract.
std::string prefixOf(const model::Interface& interface, const Context& context);

/// Names the slot of a command's parameters, of the contract that declares it:
/// "robots::ArmServoCpArguments".
std::string argumentsStruct(const model::Interface& interface, const model::Command& command,
                            const Context& context);

/// Names the slot of an event's payload: the value's own, or "robots::ArmMovedPayload" when it has
/// several. It is spelled as within namespace `inNamespace`.
std::string payloadSlot(const model::Interface& interface, const model::Event& event,
                        const Context& context, const std::string& inNamespace);

/// "namespace robots {", or nothing at global scope; and its end.
std::string openNamespace(const std::string& name);
std::string closeNamespace(const std::string& name);

/// Returns "// Written by suturec from arm/arm.h. Do not edit.\n".
std::string banner(const model::Header& header);

/// Returns "50'000'000": a number as people group it in C++.
std::string grouped(std::int64_t number);

/// Returns the value of an enumerator as people read it: "18446744073709551615".
std::string valueText(const model::Enum& type, const model::Enumerator& enumerator);

/// Returns the same as a C++ constant of the underlying type: "18'446'744'073'709'551'615u".
std::string valueLiteral(const model::Enum& type, const model::Enumerator& enumerator);
/// Tells if one of its values is written as a constant of <limits>.
bool hasLowestNumber(const model::Enum& type);

}  // namespace suture::compiler::emit
