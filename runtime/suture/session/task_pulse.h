#pragma once
// How a task does, as messages.

#include <suture/component/task/task_activity.h>
#include <suture/peer.capnp.h>

namespace suture {

void toWire(const Pulse::Reading& pulse, wire::TaskPulse::Builder out);
/// What a peer says may be anything.
Pulse::Reading fromWire(wire::TaskPulse::Reader in);

}  // namespace suture
