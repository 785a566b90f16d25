#pragma once
// Names of declarations as the model holds them.

#include <clang/AST/Decl.h>

#include <optional>
#include <string>

#include "compiler/model/reserved_names.h"

namespace suture::compiler::frontend {

/// "Pose": of what a typedef alone names, the name of the typedef; "" where nothing names it.
std::string plainName(const clang::NamedDecl* declaration);

/// "std::chrono::steady_clock": without inline namespaces and template arguments.
std::string qualifiedName(const clang::NamedDecl* declaration);

/// The enclosing namespaces of a declaration, qualified: "robots::arm".
std::string namespaceOf(const clang::Decl* declaration);

/// Wire name of a type: the one that name() gives, else from the C++ name, "foo_t" -> "FooT", of a
/// nested class with those around it, "Arm::State" -> "ArmState".
std::string wireTypeName(model::Named kind, const clang::NamedDecl* declaration,
                         const std::optional<std::string>& given);

/// Wire name of a field, parameter, method, event or enumerator: "servo_cp" -> "servoCp",
/// "POWER_ON" -> "powerOn".
std::string wireMemberName(const std::string& cxxName, const std::optional<std::string>& given);

/// Gives the same, and a word more where something else has that name on the wire.
std::string wireMemberName(model::Named kind, const std::string& cxxName,
                           const std::optional<std::string>& given);

}  // namespace suture::compiler::frontend
