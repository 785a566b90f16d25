#pragma once
// A lock as the text of its file.

#include <map>
#include <string>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {

/// The whole schema file. Deterministic; parse() of it gives the lock back, but for docs and lines.
std::string write(const Lock& lock);

/// One member as a single line, for messages: "speed @2 :Float64 $Meta.unit("m/s")".
std::string describe(const Member& member);

/// "@0x9b87d70f9fe9600f"
std::string idText(std::uint64_t id);

}  // namespace suture::compiler::lock
