#include <pthread.h>
#include <sched.h>
#include <suture/base/errors.h>
#include <suture/rt/thread.h>

#include <cstring>

namespace suture::rt {
namespace {

void pin(const std::string& name, int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(cpu, &set);
  if (const int error = pthread_setaffinity_np(pthread_self(), sizeof(set), &set); error != 0) {
    throw SetupError("cannot pin the thread of '" + name + "' to processor " + std::to_string(cpu),
                     std::strerror(error), "Choose a processor that this process may use (nproc)");
  }
}

void makeFifo(const std::string& name, int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
      error != 0) {
    throw SetupError(
        "cannot give the thread of '" + name + "' SCHED_FIFO priority " + std::to_string(priority),
        std::strerror(error),
        "Grant real-time priorities (ulimit -r, CAP_SYS_NICE) or leave it out");
  }
}

}  // namespace

void configureThisThread(const std::string& name, const Scheduling& scheduling) {
  pthread_setname_np(pthread_self(), name.substr(0, 15).c_str());
  if (scheduling.cpu) pin(name, *scheduling.cpu);
  if (scheduling.fifoPriority) makeFifo(name, *scheduling.fifoPriority);
}

}  // namespace suture::rt
