#include <gtest/gtest.h>
#include <sched.h>
#include <suture/base/errors.h>
#include <suture/rt/scheduling.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <thread>

#include "support/refusal.h"
#include "support/refused_call.h"

namespace suture::rt {
namespace {

template <class Work>
void inThread(Work work) {
  std::thread(work).join();
}

/// Returns the first processor that this process may use.
int someProcessor() {
  cpu_set_t allowed;
  sched_getaffinity(getpid(), sizeof(allowed), &allowed);
  int processor = 0;
  while (!CPU_ISSET(static_cast<std::size_t>(processor), &allowed)) ++processor;
  return processor;
}

TEST(Scheduling, ASliceLeavesPolicyAndNiceness) {
  inThread([] {
    ASSERT_EQ(setpriority(PRIO_PROCESS, 0, 7), 0);  // Linux has this for one thread
    askForSlice(kTaskSlice);
    EXPECT_EQ(getpriority(PRIO_PROCESS, 0), 7);
    EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
  });
  inThread([] {
    const sched_param none{};
    ASSERT_EQ(sched_setscheduler(0, SCHED_BATCH, &none), 0);
    askForSlice(kTaskSlice);
    EXPECT_EQ(sched_getscheduler(0), SCHED_BATCH);
  });
}

TEST(Scheduling, AThreadIsPinnedAsTold) {
  inThread([] {
    configureThisThread("a name longer than the kernel keeps", {.processor = someProcessor()});
    EXPECT_EQ(sched_getcpu(), someProcessor());
    char name[16];
    ASSERT_EQ(pthread_getname_np(pthread_self(), name, sizeof(name)), 0);
    EXPECT_STREQ(name, "a name longer t");
  });
}

TEST(Scheduling, AnAbsentProcessorIsRefused) {
  inThread([] { EXPECT_THROW(configureThisThread("far", {.processor = 1000}), SetupError); });
}

TEST(Scheduling, ARefusedWishLeavesTheOthers) {
  const Granted granted = grantedOf("far", {.processor = 1000});
  EXPECT_EQ(granted.scheduling, Scheduling{});
  ASSERT_EQ(granted.refusals.size(), 1u);
  EXPECT_EQ(granted.refusals[0],
            "cannot pin the thread of far to processor 1000: Invalid argument. Choose a "
            "processor that this process may use (nproc)");
  const int processor = someProcessor();
  const Granted nonsense = grantedOf("PSM", {Policy::Fifo, 100, processor});
  EXPECT_EQ(nonsense.scheduling, (Scheduling{.processor = processor}));
  ASSERT_EQ(nonsense.refusals.size(), 1u);
  EXPECT_EQ(nonsense.refusals[0],
            "cannot give the thread of PSM SCHED_FIFO priority 100: there is no such priority. "
            "Give one from 1 to 99");
}

TEST(Scheduling, AMissingRightTellsItsRemedy) {
  inThread([] {
    refuseCall(SYS_sched_setscheduler, EPERM);
    EXPECT_EQ(refusal([] {
                schedule("PSM", {Policy::RoundRobin, 10});
              }),
              "cannot give the thread of PSM SCHED_RR priority 10: Operation not permitted. Grant "
              "real-time priorities (ulimit -r, CAP_SYS_NICE) or leave it out");
  });
}

TEST(Scheduling, AskingLeavesTheAskersThreadAlone) {
  inThread([] {
    cpu_set_t before, after;
    sched_getaffinity(0, sizeof(before), &before);
    (void)grantedOf("PSM", {Policy::RoundRobin, 1, someProcessor()});
    EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
    sched_getaffinity(0, sizeof(after), &after);
    EXPECT_TRUE(CPU_EQUAL(&before, &after));
  });
}

TEST(Scheduling, IsToldInPlainWords) {
  EXPECT_EQ(toString(Scheduling{}), "default");
  EXPECT_EQ(toString({.processor = 2}), "default on processor 2");
  EXPECT_EQ(toString({Policy::Fifo, 80, 1}), "fifo 80 on processor 1");
  EXPECT_EQ(toString({Policy::RoundRobin, 7}), "round robin 7");
}

}  // namespace
}  // namespace suture::rt
