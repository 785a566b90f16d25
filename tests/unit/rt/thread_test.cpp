#include <gtest/gtest.h>
#include <sched.h>
#include <suture/base/errors.h>
#include <suture/rt/thread.h>
#include <sys/resource.h>

#include <thread>

namespace suture::rt {
namespace {

template <class Work>
void inThread(Work work) {
  std::thread(work).join();
}

TEST(Thread, AskingForASliceLeavesPolicyAndNicenessAlone) {
  inThread([] {
    ASSERT_EQ(setpriority(PRIO_PROCESS, 0, 7), 0);  // of this thread alone
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

TEST(Thread, IsPinnedWhereItWasTold) {
  inThread([] {
    configureThisThread("a name longer than the kernel keeps", {.cpu = 0});
    EXPECT_EQ(sched_getcpu(), 0);
    char name[16];
    ASSERT_EQ(pthread_getname_np(pthread_self(), name, sizeof(name)), 0);
    EXPECT_STREQ(name, "a name longer t");
  });
}

TEST(Thread, AProcessorThatIsNotThereIsRefused) {
  inThread([] { EXPECT_THROW(configureThisThread("far", {.cpu = 1000}), SetupError); });
}

}  // namespace
}  // namespace suture::rt
