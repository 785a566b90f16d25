#include <suture/base/errors.h>
#include <suture/component/task/guest_task.h>

namespace suture {

void GuestTask::start() {
  if (host_ != nullptr) return;
  throw SetupError("starting '" + name() + "'", "no task lends it a thread",
                   "Call lend() of the task whose cycles it shall follow, before starting");
}

void GuestTask::accept(Task& host) {
  const std::string asked = "lending the thread of '" + host.name() + "' to '" + name() + "'";
  if (host_ != nullptr) {
    throw SetupError(asked, "it already has that of '" + host_->name() + "'",
                     "A task runs in one thread");
  }
  if (host.state() != ComponentState::Constructed && host.state() != ComponentState::Configured) {
    throw SetupError(asked, "'" + host.name() + "' has been started", "Lend before starting");
  }
  if (isConnected()) {
    throw SetupError(asked, "'" + name() + "' is already connected", "Lend before connecting");
  }
  host_ = &host;
  borrowThread(host);
}

}  // namespace suture
