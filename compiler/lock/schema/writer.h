#pragma once
// This writes a lock as the text of its file.

#include <map>
#include <string>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// Returns the whole schema file. Equal locks give equal text, and parse() of it gives the lock
/// back, but for docs and lines.
std::string write(const Lock& lock);

/// Returns the same with `about`, a comment, in place of what a lock says of itself.
std::string write(const Lock& lock, const std::string& about);

/// Returns one member as a single line, for messages: "speed @2 :Float64 $Meta.unit("m/s")".
std::string describe(const Member& member);

/// Returns the id as a schema spells it: "@0x9b87d70f9fe9600f".
std::string idText(std::uint64_t id);

}  // namespace suture::compiler::lock
