#pragma once
// Names of declarations as the model holds them.

#include <clang/AST/Decl.h>

#include <string>

namespace suture::compiler::frontend {

/// "std::chrono::steady_clock": without inline namespaces and template arguments.
std::string qualifiedName(const clang::NamedDecl* declaration);

/// The enclosing namespaces of a declaration, qualified: "robots::arm".
std::string namespaceOf(const clang::Decl* declaration);

/// Wire name of a type: the one that name() gives, else from the C++ name, "foo_t" -> "FooT".
std::string wireTypeName(const clang::NamedDecl* declaration,
                         const std::optional<std::string>& given);

/// Wire name of a field, parameter, method, event or enumerator: "servo_cp" -> "servoCp",
/// "POWER_ON" -> "powerOn".
std::string wireMemberName(const std::string& cxxName, const std::optional<std::string>& given);

}  // namespace suture::compiler::frontend
