#pragma once
// This converts the activity of a task to and from messages.

#include <suture/component/task/task_activity.h>
#include <suture/peer.capnp.h>

namespace suture {

void toWire(const TaskActivity::Reading& activity, wire::TaskActivity::Builder out);
/// Accepts any values, because a peer wrote them.
TaskActivity::Reading fromWire(wire::TaskActivity::Reader in);

}  // namespace suture
