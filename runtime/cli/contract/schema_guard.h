#pragma once
// This checks a schema that came over a wire, before Cap'n Proto's own check.

#include <capnp/schema.capnp.h>

#include <optional>
#include <string>

namespace suture::cli {

/// Returns what is wrong with the layout of a struct among `nodes`, if anything is. Release 0.9.2
/// compares offsets in 32 bits, where a large one passes, and trusts the size that a group claims;
/// a value would then be written outside of its message.
std::optional<std::string> faultIn(capnp::List<capnp::schema::Node>::Reader nodes);

}  // namespace suture::cli
