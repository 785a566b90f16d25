// The global manager's capabilities work on a clock of the test.

#include <gtest/gtest.h>
#include <suture/names/manager_session.h>

namespace suture {
namespace {

/// Holds a manager and a session with it.
class Service {
 public:
  Service() {
    auto hello = manager_.helloRequest();
    hello.setVersion(wire::PROTOCOL_VERSION);
    session_ = hello.send().wait(scope_).getSession();
  }

  /// Returns why a process of `version` of the protocol gets no session, or "".
  std::string refusalOf(std::uint16_t version) {
    auto hello = manager_.helloRequest();
    hello.setVersion(version);
    hello.setProgram("old");
    auto results = hello.send().wait(scope_);
    return results.isRefused() ? std::string(results.getRefused().getText().cStr()) : "";
  }
  wire::Lease::Client enrol(const char* name) {
    auto request = session_.registerRequest();
    request.initProcess().setName(name);
    return request.send().wait(scope_).getLease();
  }
  bool renew(wire::Lease::Client& lease) {
    return lease.renewRequest().send().wait(scope_).getHeld();
  }
  /// Lets the time of so many renewals pass.
  void pass(int renewals) {
    for (int i = 0; i < renewals; ++i) {
      present_ += wire::RENEWAL_MILLISECONDS * kj::MILLISECONDS;
      timer_.advanceTo(present_);
      scope_.poll();
    }
  }
  auto resolve(const char* name) {
    auto request = session_.resolveRequest();
    request.setProcess(name);
    request.setWaitMilliseconds(60'000);
    return request.send();
  }
  kj::WaitScope& scope() { return scope_; }

 private:
  kj::EventLoop loop_;
  kj::WaitScope scope_{loop_};
  kj::TimePoint present_ = kj::origin<kj::TimePoint>();
  kj::TimerImpl timer_{present_};
  net::Refusals refusals_{"manager"};
  wire::GlobalManager::Client manager_ = makeGlobalManager(
      kj::refcounted<NameService>(timer_), refusals_, std::make_shared<framing::Caller>());
  wire::Session::Client session_ = nullptr;
};

TEST(NameService, AnotherProtocolIsRefused) {
  Service service;
  EXPECT_EQ(service.refusalOf(1),
            "talk to the global manager: it speaks version " +
                std::to_string(wire::PROTOCOL_VERSION) +
                " of the protocol and 'old' speaks version 1. Build both from the same release.");
  EXPECT_EQ(service.refusalOf(wire::PROTOCOL_VERSION), "");
}

TEST(NameService, AWaiterHearsOfTheReturn) {
  Service service;
  auto lease = service.enrol("left");
  ASSERT_TRUE(service.renew(lease));
  service.pass(wire::MISSABLE_RENEWALS);
  EXPECT_TRUE(service.resolve("left").poll(service.scope()));
  service.pass(1);
  auto found = service.resolve("left");
  EXPECT_FALSE(found.poll(service.scope()));
  EXPECT_TRUE(service.renew(lease));
  ASSERT_TRUE(found.poll(service.scope()));
  EXPECT_TRUE(found.wait(service.scope()).isFound());
}

TEST(NameService, ASilentProcessHearsOfItsLoss) {
  Service service;
  auto lease = service.enrol("left");
  ASSERT_TRUE(service.renew(lease));
  service.pass(wire::MISSABLE_RENEWALS + 1);
  auto successor = service.enrol("left");
  EXPECT_FALSE(service.renew(lease));
  EXPECT_TRUE(service.renew(successor));
}

}  // namespace
}  // namespace suture
