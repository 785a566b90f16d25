#pragma once
// Composites are types that travel as a struct of their own although they are declared nowhere:
// optionals, variants, tuples, the entries of maps, matrices of any size. Each header's schema
// holds those that it uses, named after what they are made of: "ArmOptionalFloat64".

#include <functional>
#include <string>
#include <vector>

#include "compiler/model/lookup.h"

namespace suture::compiler::lock {

/// Tells if the type travels as such a struct or, if it is a map, as a list of such structs.
bool isComposite(const model::Type& type);

/// Returns what the names of the header's composites begin with: "RobotsArm" for "robots/arm.h",
/// "Arm" for "arm/arm.h" and "Header03ArmArm" for "03_arm/arm.h", since a name begins with a
/// letter. Two headers may have one prefix until settled() has told them apart.
std::string prefixOf(const model::Header& header);

/// Returns the name of that struct in the schema of `inside`.
std::string compositeName(const model::Type& type, const model::Lookup& lookup,
                          const model::Header& inside);

/// Returns the names of its members, one for each element of the type: "key" and "value" of a map,
/// one for each alternative of a variant.
std::vector<std::string> compositeMembers(const model::Type& type, const model::Lookup& lookup,
                                          const model::Header& inside);

/// Calls `visit` for every composite among the types of the header's contracts and of those structs
/// for which `counts` returns true, parts before wholes. It may visit the same one again. The
/// source is that of what has the type.
void forEachComposite(const model::Header& header,
                      const std::function<bool(const model::Struct&)>& counts,
                      const std::function<void(const model::Type&, const model::Source&)>& visit);

/// Calls `visit` for every composite within one type, parts before wholes.
void forEachComposite(const model::Type& type,
                      const std::function<void(const model::Type&)>& visit);

}  // namespace suture::compiler::lock
