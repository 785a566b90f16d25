#pragma once
// This says what a lane can carry at all, before there are processes to connect.

#include <suture/base/errors.h>
#include <suture/component/contract/interface_info.h>
#include <suture/lane/lane.h>

#include <string>

namespace suture {

/// Returns why no connection of this contract can ever travel by `lane`; "" if one may.
/// `byUnixSocket` says how its two processes reach each other.
std::string whyNever(Lane lane, const InterfaceInfo& contract, bool byUnixSocket);

/// Returns the refusal of a connection that requires a lane which cannot carry it.
SetupError laneRefused(const std::string& connection, Lane lane, const std::string& why);

}  // namespace suture
