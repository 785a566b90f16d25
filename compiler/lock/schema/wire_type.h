#pragma once
// How a C++ type reads on the wire: capnp's spelling, and beside it what capnp cannot say.

#include <map>
#include <string>
#include <string_view>

#include "compiler/model/lookup.h"
#include "compiler/model/type.h"

namespace suture::compiler::lock {

/// Annotations that say what bytes mean, and so are guarded like types.
inline constexpr const char* kMeaningful[] = {"unit", "period", "clock", "shape", "kind", "bulk"};

/// Fixed double-precision Eigen types that have a named struct in suture/types.capnp.
/// "/suture/types.capnp:Vec3"; "" when the type has none and travels as a flat list.
std::string namedEigenType(const model::Type& type);

/// Does it travel as one flat list of the coefficients of all its vectors?
bool isFlatList(const model::Type& type);

/// What the numbers of a bulk() type are: "Float64"; "" where they are no block of bytes.
std::string bulkScalar(const model::Type& type);

/// The number that a scalar or a duration travels as.
model::Scalar wireScalar(const model::Type& type);

/// "Int32", "Float64"...
std::string_view capnpScalar(model::Scalar scalar);

/// A declared enum, struct or contract by its qualified C++ name: "PoseStamped", or of another file
/// "/arm/arm.capnp:PoseStamped".
std::string declaredType(const std::string& name, const model::Lookup& lookup,
                         const model::Header& inside);

/// "List(Int32)"; a type of another file as "/arm/arm.capnp:PoseStamped".
std::string wireType(const model::Type& type, const model::Lookup& lookup,
                     const model::Header& inside);

/// shape, period, clock, capacity: those that apply, in the form of Member::annotations.
std::map<std::string, std::string> typeAnnotations(const model::Type& type);

/// `text` as a capnp string literal, quotes included.
std::string quoted(std::string_view text);
/// The text of such a literal.
std::string unquoted(std::string_view literal);

}  // namespace suture::compiler::lock
