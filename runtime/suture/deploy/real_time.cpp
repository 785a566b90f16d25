#include <suture/component/task/task.h>
#include <suture/deploy/real_time.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace suture {
namespace {

/// Returns true if the process may not lock as much more memory as its limit.
bool isLimited() {
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  if (limit.rlim_cur == RLIM_INFINITY) return false;
  void* const more = mmap(nullptr, limit.rlim_cur + 1, PROT_NONE,
                          MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (more == MAP_FAILED) return true;
  munmap(more, limit.rlim_cur + 1);
  return false;
}

/// Locks all memory and returns "", or returns why the kernel refuses. Under a limit it locks none,
/// because the kernel would refuse memory later, when the process needs more.
std::string lockAll() {
  const bool locked = mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
  const int error = errno;
  if (!locked && error != ENOMEM && error != EPERM) return std::strerror(error);
  if (locked && !isLimited()) return "";
  munlockall();
  return "this user may lock a limited amount only";
}

}  // namespace

void giveScheduling(const JsonDocument& document, const ProcessEntry& process,
                    std::span<const std::unique_ptr<Component>> components,
                    std::vector<std::string>& problems) {
  for (std::size_t i = 0; i < components.size(); ++i) {
    const ComponentEntry& entry = process.components[i];
    if (!entry.scheduling || components[i] == nullptr) continue;
    Component& component = *components[i];
    const bool done =
        component.ownsThread() && static_cast<Task&>(component).schedule(*entry.scheduling);
    if (done) continue;
    problems.push_back(document.locate(
        entry.pointer + "/scheduling",
        "component '" + entry.name + "' of class '" + entry.className +
            "' is to be scheduled, but it has no thread of its own; remove 'scheduling', or "
            "schedule the component in whose thread it runs"));
  }
}

RealTime::RealTime(const JsonDocument& document, const ProcessEntry& process)
    : document_(document), process_(process) {
  if (process_.lockMemory) lockMemory();
  for (const ComponentEntry& entry : process_.components) {
    components_.push_back(
        granted("component '" + entry.name + "'", entry.scheduling, entry.pointer));
  }
  service_ = granted("the connections of process '" + process_.name + "'", process_.scheduling,
                     process_.pointer);
  if (!problems_.empty()) throw DocumentError(problems_);
}

void RealTime::lockMemory() {
  const std::string why = lockAll();
  if (why.empty()) return;
  refuse(process_.pointer + "/lock_memory",
         "cannot lock the memory of process '" + process_.name + "': " + why +
             ". Grant it (ulimit -l unlimited, CAP_IPC_LOCK) or leave it out");
}

RealTime::Wish RealTime::granted(const std::string& whose, const Wish& wanted,
                                 const std::string& pointer) {
  if (!wanted) return std::nullopt;
  const rt::Granted granted = rt::grantedOf(whose, *wanted);
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

void RealTime::giveTo(std::span<const std::unique_ptr<Component>> components) const {
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (components_[i]) static_cast<Task&>(*components[i]).schedule(*components_[i]);
  }
}

void RealTime::giveTo(Manager& manager) const {
  if (service_) manager.scheduleService(*service_);
}

std::vector<std::string> RealTime::news() { return std::exchange(warnings_, {}); }

}  // namespace suture
