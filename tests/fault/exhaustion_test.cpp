// This provider has no descriptor left for one more caller.

#include <gtest/gtest.h>
#include <suture/net/address.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "fault/system.h"

namespace suture {
namespace {

constexpr int kDescriptors = 40;

std::size_t descriptorsOf(const Child& child) {
  const std::filesystem::directory_iterator all("/proc/" + std::to_string(child.pid()) + "/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

/// This is a crowd of callers that say nothing.
class Crowd {
 public:
  explicit Crowd(const net::Address& address) : address_(address) {}
  ~Crowd() { leave(); }
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  /// Returns false if the provider takes no more callers: as many wait as may.
  bool join() {
    const net::SocketAddress target(address_);
    const int caller = socket(target.family(), SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (connect(caller, target.get(), target.length) == 0) {
      callers_.push_back(caller);
      return true;
    }
    close(caller);
    return false;
  }
  std::size_t size() const { return callers_.size(); }
  void leave() {
    for (const int caller : callers_) close(caller);
    callers_.clear();
  }

 private:
  const net::Address address_;
  std::vector<int> callers_;
};

TEST(Exhaustion, ConnectedClientsDoNotNoticeIt) {
  System system;
  const auto manager = system.manager();
  const auto provider = system.provider("robot", [] {
    const rlimit few{kDescriptors, kDescriptors};
    setrlimit(RLIMIT_NOFILE, &few);
  });
  ASSERT_EQ(provider->line(), "ready");
  const auto first = system.client("busy", 5000);
  ASSERT_EQ(first->line(), "begun");
  ASSERT_EQ(first->line(), "ready");
  ASSERT_TRUE(system.works(true));
  const std::size_t quiet = descriptorsOf(*provider);

  Crowd crowd(net::Address::parse("unix:" + system.socketOf("robot", *provider)));
  // A sanitizer may keep some for itself.
  ASSERT_TRUE(
      eventually([&] { return !crowd.join() && descriptorsOf(*provider) >= kDescriptors - 3; }));
  const std::size_t callers = crowd.size();
  EXPECT_TRUE(system.works(true)) << "who is connected goes on";

  const auto second = system.client("busy", 5000);
  ASSERT_EQ(second->line(), "begun");
  crowd.leave();
  EXPECT_EQ(second->line(), "ready") << "as soon as there is room";
  EXPECT_TRUE(system.works(true));
  // One client more has a socket, and the memory that it shares.
  EXPECT_TRUE(eventually([&] { return descriptorsOf(*provider) <= quiet + 4; }))
      << descriptorsOf(*provider) << " after " << quiet;
  EXPECT_EQ(first->end(SIGTERM), 0);
  EXPECT_EQ(second->end(SIGTERM), 0);
  EXPECT_EQ(provider->end(SIGTERM), 0);
  expectSoundHistory(system.history());
  std::printf("%zu callers too many\n", callers);
  EXPECT_GT(callers, 0u);
}

}  // namespace
}  // namespace suture
