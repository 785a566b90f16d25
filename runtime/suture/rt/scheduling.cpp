#include <pthread.h>
#include <sched.h>
#include <suture/base/errors.h>
#include <suture/rt/scheduling.h>
#include <suture/rt/thread.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstring>

namespace suture::rt {
namespace {

void pin(const std::string& name, int processor) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<std::size_t>(processor), &set);
  if (const int error = pthread_setaffinity_np(pthread_self(), sizeof(set), &set); error != 0) {
    throw SetupError(
        "cannot pin the thread of " + name + " to processor " + std::to_string(processor),
        std::strerror(error), "Choose a processor that this process may use (nproc)");
  }
}

void prioritize(const std::string& name, const Scheduling& scheduling) {
  const bool fifo = scheduling.policy == Policy::Fifo;
  const std::string asked = "cannot give the thread of " + name + " " +
                            (fifo ? "SCHED_FIFO" : "SCHED_RR") + " priority " +
                            std::to_string(scheduling.priority);
  if (scheduling.priority < 1 || scheduling.priority > 99) {
    throw SetupError(asked, "there is no such priority", "Give one from 1 to 99");
  }
  sched_param parameters{};
  parameters.sched_priority = scheduling.priority;
  const int error =
      pthread_setschedparam(pthread_self(), fifo ? SCHED_FIFO : SCHED_RR, &parameters);
  if (error == 0) return;
  throw SetupError(asked, std::strerror(error),
                   "Grant real-time priorities (ulimit -r, CAP_SYS_NICE) or leave it out");
}

/// This is the kernel's struct sched_attr, which glibc 2.36 does not declare.
struct SchedulingAttributes {
  std::uint32_t size = sizeof(SchedulingAttributes);
  std::uint32_t policy = SCHED_OTHER;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime = 0, deadline = 0, period = 0;
};

/// Tries one part of a wish. Returns false if it is refused.
bool isGranted(const std::string& name, const Scheduling& part,
               std::vector<std::string>& refusals) {
  try {
    schedule(name, part);
    return true;
  } catch (const SetupError& error) {
    refusals.emplace_back(error.what());
    return false;
  }
}

}  // namespace

std::string toString(const Scheduling& scheduling) {
  std::string text = "default";
  if (scheduling.policy != Policy::Default) {
    text = (scheduling.policy == Policy::Fifo ? "fifo " : "round robin ") +
           std::to_string(scheduling.priority);
  }
  if (scheduling.processor) text += " on processor " + std::to_string(*scheduling.processor);
  return text;
}

void askForSlice(Duration slice) {
  if (sched_getscheduler(0) != SCHED_OTHER) return;
  SchedulingAttributes attributes;
  attributes.nice = getpriority(PRIO_PROCESS, 0);
  attributes.runtime = static_cast<std::uint64_t>(slice.count());
  syscall(SYS_sched_setattr, 0, &attributes, 0);
}

void schedule(const std::string& name, const Scheduling& scheduling) {
  if (scheduling.processor) pin(name, *scheduling.processor);
  if (scheduling.policy != Policy::Default) prioritize(name, scheduling);
}

void configureThisThread(const std::string& name, const Scheduling& scheduling) {
  pthread_setname_np(pthread_self(), name.substr(0, 15).c_str());
  prctl(PR_SET_TIMERSLACK, 1UL);  // ns; else the kernel may end every timed sleep 50 us late
  schedule(name, scheduling);
  askForSlice(kTaskSlice);
}

// Each part is asked for separately, because the kernel may grant a processor without granting
// real-time priorities.
Granted grantedOf(const std::string& name, const Scheduling& wanted) {
  Granted granted;
  Thread thread;
  thread.start(name, [&] {
    if (isGranted(name, {.processor = wanted.processor}, granted.refusals)) {
      granted.scheduling.processor = wanted.processor;
    }
    if (isGranted(name, {wanted.policy, wanted.priority}, granted.refusals)) {
      granted.scheduling.policy = wanted.policy;
      granted.scheduling.priority = wanted.priority;
    }
  });
  thread.join();
  return granted;
}

}  // namespace suture::rt
