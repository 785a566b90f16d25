#pragma once
// How a task does, as messages.

#include <suture/component/task/task_activity.h>
#include <suture/peer.capnp.h>

namespace suture {

void toWire(const TaskActivity::Reading& activity, wire::TaskActivity::Builder out);
/// What a peer says may be anything.
TaskActivity::Reading fromWire(wire::TaskActivity::Reader in);

}  // namespace suture
