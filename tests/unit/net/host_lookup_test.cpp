// A thread that asks the name service takes nothing from the thread that it was started by.

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <netdb.h>
#include <sched.h>
#include <suture/net/host_lookup.h>
#include <unistd.h>

#include <cstring>
#include <future>
#include <thread>

namespace {

constexpr const char* kHost = "observed.test";

struct Placing {
  int policy = -1;
  cpu_set_t processors{};
};
std::promise<Placing> asking;

}  // namespace

// The program's own comes before that of the system's library, to which it hands all but kHost.
extern "C" int getaddrinfo(const char* host, const char* service, const addrinfo* hints,
                           addrinfo** all) {
  if (std::strcmp(host, kHost) == 0) {
    Placing placing{.policy = sched_getscheduler(0)};
    sched_getaffinity(0, sizeof placing.processors, &placing.processors);
    asking.set_value(placing);
    return EAI_NONAME;
  }
  static const auto systems =
      reinterpret_cast<decltype(&getaddrinfo)>(dlsym(RTLD_NEXT, "getaddrinfo"));
  return systems(host, service, hints, all);
}

namespace suture::net {
namespace {

/// Gives the calling thread one processor, and another policy than an ordinary thread.
void leaveOrdinary(const cpu_set_t& processors) {
  int last = 0;
  for (int i = 0; i < CPU_SETSIZE; ++i) last = CPU_ISSET(i, &processors) ? i : last;
  cpu_set_t one{};
  CPU_SET(last, &one);
  EXPECT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  const sched_param none{};
  EXPECT_EQ(sched_setscheduler(0, SCHED_BATCH, &none), 0);
}

TEST(HostLookups, AreAskedByAnOrdinaryThread) {
  cpu_set_t processors{};
  ASSERT_EQ(sched_getaffinity(getpid(), sizeof processors, &processors), 0);
  std::thread([&] {
    leaveOrdinary(processors);
    loop::EventPort port;
    HostLookup lookup(port, Address::parse(std::string("tls://") + kHost + ":7700"));
    const auto found = lookup.places(std::chrono::seconds(10))
                           .then([](auto&&) { return true; }, [](kj::Exception&&) { return false; })
                           .wait(port.scope());
    EXPECT_FALSE(found);
  }).join();
  const Placing placing = asking.get_future().get();
  EXPECT_EQ(placing.policy, SCHED_OTHER);
  EXPECT_TRUE(CPU_EQUAL(&placing.processors, &processors));
}

}  // namespace
}  // namespace suture::net
