#pragma once
// These name declarations as the model holds them.

#include <clang/AST/Decl.h>

#include <optional>
#include <string>

#include "compiler/model/reserved_names.h"

namespace suture::compiler::frontend {

/// Returns the unqualified name, such as "Pose". If only a typedef names the type, that is the name
/// of the typedef; it is "" if nothing does.
std::string plainName(const clang::NamedDecl* declaration);

/// Returns the name without inline namespaces and template arguments: "std::chrono::steady_clock".
std::string qualifiedName(const clang::NamedDecl* declaration);

/// Returns the name as C++ finds it from any namespace: "::Pose" of what is in none, where another
/// Pose might be nearer.
std::string rootedName(const clang::NamedDecl* declaration);

/// Returns the enclosing namespaces of a declaration, qualified: "robots::arm".
std::string namespaceOf(const clang::Decl* declaration);

/// Returns the wire name of a type: the one that name() gives, else "FooT" for the C++ name
/// "foo_t". The name of a nested class has those around it in front: "ArmState" for "Arm::State".
std::string wireTypeName(model::Named kind, const clang::NamedDecl* declaration,
                         const std::optional<std::string>& given);

/// Returns the wire name of a field, parameter, method, event or enumerator: "servoCp" for
/// "servo_cp", "powerOn" for "POWER_ON".
std::string wireMemberName(const std::string& cxxName, const std::optional<std::string>& given);

/// Returns such a name, with a word more if something else has that name on the wire.
std::string wireMemberName(model::Named kind, const std::string& cxxName,
                           const std::optional<std::string>& given);

}  // namespace suture::compiler::frontend
