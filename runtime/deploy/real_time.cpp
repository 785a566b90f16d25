#include <linux/capability.h>
#include <suture/component/task.h>
#include <suture/deploy/real_time.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace suture {
namespace {

bool mayLockWithoutLimit() {
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  if (limit.rlim_cur == RLIM_INFINITY) return true;
  __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> sets{};
  if (syscall(SYS_capget, &header, sets.data()) != 0) return false;
  return (sets[CAP_TO_INDEX(CAP_IPC_LOCK)].effective & CAP_TO_MASK(CAP_IPC_LOCK)) != 0;
}

/// Why not; "" if all memory is locked. Under a limit all would be well until the process needs
/// more, which the kernel then refuses: so it is not locked at all.
std::string lockAll() {
  if (!mayLockWithoutLimit()) return "this user may lock a limited amount only";
  return mlockall(MCL_CURRENT | MCL_FUTURE) == 0 ? "" : std::strerror(errno);
}

}  // namespace

RealTime::RealTime(const JsonDocument& document, const ProcessEntry& process)
    : document_(document), process_(process) {
  if (process_.lockMemory) lockMemory();
}

void RealTime::lockMemory() {
  const std::string why = lockAll();
  if (why.empty()) return;
  refuse(process_.pointer + "/lock_memory",
         "cannot lock the memory of process '" + process_.name + "': " + why +
             ". Grant it (ulimit -l unlimited, CAP_IPC_LOCK) or leave it out");
}

void RealTime::giveTo(std::span<const std::unique_ptr<Component>> components, Manager& manager) {
  for (std::size_t i = 0; i < components.size(); ++i) {
    const ComponentEntry& entry = process_.components[i];
    if (entry.scheduling) schedule(*components[i], entry);
  }
  if (process_.scheduling) {
    manager.scheduleService(granted("the connections of process '" + process_.name + "'",
                                    *process_.scheduling, process_.pointer));
  }
  if (!problems_.empty()) throw DocumentError(problems_);
}

void RealTime::schedule(Component& component, const ComponentEntry& entry) {
  const rt::Scheduling scheduling =
      granted("component '" + entry.name + "'", *entry.scheduling, entry.pointer);
  const bool done = component.ownsThread() && static_cast<Task&>(component).schedule(scheduling);
  if (done) return;
  problems_.push_back(document_.locate(
      entry.pointer + "/scheduling",
      "component '" + entry.name + "' of class '" + entry.className +
          "' is to be scheduled, but it has no thread of its own; remove 'scheduling', or "
          "schedule the component in whose thread it runs"));
}

rt::Scheduling RealTime::granted(const std::string& whose, const rt::Scheduling& wanted,
                                 const std::string& pointer) {
  const rt::Granted granted = rt::grantedOf(whose, wanted);
  for (const std::string& refusal : granted.refusals) refuse(pointer + "/scheduling", refusal);
  return granted.scheduling;
}

void RealTime::refuse(const std::string& pointer, const std::string& text) {
  if (process_.realTimeRequired) {
    problems_.push_back(document_.locate(pointer, text));
  } else {
    warnings_.push_back(document_.warn(pointer, text + "; it runs without"));
  }
}

std::vector<std::string> RealTime::news() { return std::exchange(warnings_, {}); }

}  // namespace suture
