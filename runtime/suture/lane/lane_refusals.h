#pragma once
// This says why a connection cannot have the lane that it asks for.

#include <suture/base/errors.h>
#include <suture/lane/lane.h>

#include <string>
#include <vector>

namespace suture {

/// Returns the refusal of a connection that asks for a lane which its process does not have.
/// `known` are the names of those that it has.
SetupError laneUnknown(const std::string& connection, const Lane& lane,
                       const std::vector<std::string>& known);

/// Returns the refusal of a connection that requires a lane which cannot carry it.
SetupError laneRefused(const std::string& connection, const Lane& lane, const std::string& why);

}  // namespace suture
