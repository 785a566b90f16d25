#pragma once
// Types that travel as a struct of their own although nobody declares one: optionals, variants,
// tuples, the entries of maps, matrices of any size. Each header's schema holds those that it uses,
// named after what they are made of: "ArmOptionalFloat64".

#include <functional>
#include <string>
#include <vector>

#include "compiler/model/lookup.h"

namespace suture::compiler::lock {

/// Does it travel as such a struct, or a map: as a list of such structs?
bool isComposite(const model::Type& type);

/// The name of that struct in the schema of `inside`.
std::string compositeName(const model::Type& type, const model::Lookup& lookup,
                          const model::Header& inside);

/// The names of its members, one for each element of the type: "key", "value"; of a variant one for
/// each alternative.
std::vector<std::string> compositeMembers(const model::Type& type, const model::Lookup& lookup,
                                          const model::Header& inside);

/// Calls visit for every composite among the types of the header's contracts and of those structs
/// that `counts` says yes to, parts before wholes; the same one may come again.
void forEachComposite(const model::Header& header,
                      const std::function<bool(const model::Struct&)>& counts,
                      const std::function<void(const model::Type&)>& visit);

/// The same for one type.
void forEachComposite(const model::Type& type,
                      const std::function<void(const model::Type&)>& visit);

}  // namespace suture::compiler::lock
