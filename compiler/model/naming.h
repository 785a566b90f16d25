#pragma once
// This is how names change between C++, Cap'n Proto and the C++ that capnp writes.

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace suture::compiler::model {

/// suturec itself puts these among the methods, parameters, events and columns of every contract.
/// They are names on the wire.
inline constexpr std::string_view kBuiltInMethod = "subscribe";
inline constexpr std::string_view kBuiltInParameter = "sent";
inline constexpr std::array<std::string_view, 1> kBuiltInEvents{"state"};
inline constexpr std::array<std::string_view, 3> kBuiltInColumns{"stamp", "evaluated", "tooLarge"};

/// Turns "servo_cp" into "servoCp": what capnp demands of fields, methods and enumerators.
std::string camelCase(std::string_view cxxName);

/// Turns "servoCp" into "ServoCp": as capnp spells it in accessors (getServoCp).
std::string titleCase(std::string_view wireName);

/// Turns "notReady" into "NOT_READY": as capnp spells an enumerator in C++.
std::string upperSnakeCase(std::string_view wireName);

/// Turns "robots::arm::PoseStamped" into "PoseStamped".
std::string unqualified(std::string_view cxxName);

/// Turns "robots::arm::PoseStamped" into "robots::arm"; "" at global scope.
std::string namespaceOf(std::string_view cxxName);

/// Returns the qualified name that the declaration `name` had before, as its was() gives it;
/// nothing if it has none. A was() without a namespace means that of `name`.
std::optional<std::string> formerName(const std::string& name,
                                      const std::optional<std::string>& was);

/// Turns "robots::arm" into "robots::arm::wire": where capnp's C++ of a header lives.
std::string wireNamespace(std::string_view cxxNamespace);

/// Turns "arm/arm.h" into "arm/arm": what the names of all its artefacts begin with.
std::string stemOf(std::string_view headerPath);

/// Replaces each character that no name on the wire can have by '_'. Slashes stay.
std::string plainPath(std::string path);

}  // namespace suture::compiler::model
