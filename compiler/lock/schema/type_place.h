#pragma once
// A type of a lock may be a list of lists; what counts is its leaf: where that is declared, and how
// it is spelled from another file.

#include <compare>
#include <string>

namespace suture::compiler::lock {

/// Placeholders that once named a type of another file have this type. They take as much of a
/// message as that did.
inline constexpr char kForgotten[] = "AnyPointer";
inline constexpr char kForgottenEnum[] = "UInt16";

/// Returns "Pose" for "List(Pose)".
std::string leafOf(const std::string& type);

/// Returns "List(Placement)" for "List(Pose)" and "Placement".
std::string withLeaf(const std::string& type, const std::string& leaf);

/// Says in which file something is declared, and under which name.
struct TypePlace {
  std::string path;  ///< "arm/arm.capnp"
  std::string name;

  auto operator<=>(const TypePlace&) const = default;
  /// Returns "/arm/arm.capnp:Pose".
  std::string text() const { return "/" + path + ":" + name; }
  /// Returns the place as the file `inside` spells it, which is the plain name in its own file.
  std::string spelled(const std::string& inside) const { return path == inside ? name : text(); }
};

/// Returns the place of the leaf of a type that stands in the file `inside`. A type of capnp seems
/// to be declared in that file, which has no node of its name.
TypePlace placeOf(const std::string& type, const std::string& inside);

}  // namespace suture::compiler::lock
