#pragma once
// These say how a C++ type reads on the wire: in capnp's spelling, and in annotations beside it for
// what capnp cannot say.

#include <map>
#include <string>
#include <string_view>

#include "compiler/model/lookup.h"
#include "compiler/model/type.h"

namespace suture::compiler::lock {

/// These annotations say what bytes mean, and so are guarded like types.
inline constexpr const char* kMeaningful[] = {"unit", "period", "clock", "shape", "kind", "bulk"};

/// Returns the named struct in suture/types.capnp of a fixed double-precision Eigen type,
/// "/suture/types.capnp:Vec3", or "" if the type has none and travels as a flat list.
std::string namedEigenType(const model::Type& type);

/// Tells if the type travels as one flat list of the coefficients of all its vectors.
bool isFlatList(const model::Type& type);

/// Says what the numbers of a bulk() type are, such as "Float64"; returns "" if the type is not
/// bulk().
std::string bulkScalar(const model::Type& type);

/// Returns the number that a scalar or a duration travels as.
model::Scalar wireScalar(const model::Type& type);

/// Spells the scalar as capnp does: "Int32", "Float64".
std::string_view capnpScalar(model::Scalar scalar);

/// Spells a declared enum, struct or contract, given its qualified C++ name: "PoseStamped", or
/// "/arm/arm.capnp:PoseStamped" if it is of another file.
std::string declaredType(const std::string& name, const model::Lookup& lookup,
                         const model::Header& inside);

/// Spells the type: "List(Int32)"; one of another file is "/arm/arm.capnp:PoseStamped".
std::string wireType(const model::Type& type, const model::Lookup& lookup,
                     const model::Header& inside);

/// Returns those of shape, period, clock, bulk, capacity and distinct that apply, in the form of
/// Member::annotations.
std::map<std::string, std::string> typeAnnotations(const model::Type& type);

/// Returns `text` as a capnp string literal, quotes included.
std::string quoted(std::string_view text);
/// Returns the text of such a literal.
std::string unquoted(std::string_view literal);

}  // namespace suture::compiler::lock
