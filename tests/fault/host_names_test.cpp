// The global manager is known by the name of its host, and the name service fails. The tests need
// root, since the processes have a name service of their own.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <kj/io.h>
#include <netinet/in.h>
#include <poll.h>
#include <sched.h>
#include <suture/manager/manager.h>
#include <sys/mount.h>
#include <sys/socket.h>

#include <fstream>

#include "fault/system.h"
#include "support/contains.h"
#include "support/refusal.h"

namespace suture {
namespace {

constexpr const char* kServer = "127.0.0.53";

/// Gives processes that call enter() a file of names, and a server that knows nothing.
class NameService {
 public:
  NameService() {
    write("nsswitch.conf", "hosts: files dns\n");
    write("resolv.conf", std::string("nameserver ") + kServer + "\noptions timeout:3 attempts:1\n");
    forget();
  }
  /// Gives the calling process this name service. Call it in a child, before its program starts.
  void enter() const {
    if (unshare(CLONE_NEWNS) != 0 ||
        mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0)
      std::abort();
    for (const std::string name : {"hosts", "nsswitch.conf", "resolv.conf"}) {
      const std::string mine = directory_.file(name), systems = "/etc/" + name;
      if (mount(mine.c_str(), systems.c_str(), nullptr, MS_BIND, nullptr) != 0) std::abort();
    }
  }

  void know(const std::string& host, const std::string& number) {
    write("hosts", number + " " + host + "\n");
    silent_ = nullptr;
  }
  /// From now on names cannot be found, and the service says so at once.
  void forget() { write("hosts", "127.0.0.1 localhost\n"); }
  /// From now on names cannot be found, and the service never answers.
  void fallSilent() {
    forget();
    silent_ = kj::AutoCloseFd(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_port = htons(53);
    inet_pton(AF_INET, kServer, &here.sin_addr);
    EXPECT_EQ(bind(silent_, reinterpret_cast<sockaddr*>(&here), sizeof here), 0);
  }

  /// Waits for a question, and returns false if none comes; only after fallSilent().
  bool wasAsked() const {
    pollfd question{silent_.get(), POLLIN, 0};
    return poll(&question, 1, 10'000) == 1;
  }

 private:
  // Writes the file in place, since it is mounted elsewhere.
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_.file(name)) << text;
  }

  const TemporaryDirectory directory_;
  kj::AutoCloseFd silent_;  // the server, when it takes questions and does not answer
};

class HostNames : public testing::Test {
 public:
  ~HostNames() noexcept override {}

 protected:
  void SetUp() override {
    if (geteuid() != 0) GTEST_SKIP() << "only root may give processes a name service of their own";
    ASSERT_EQ(unshare(CLONE_NEWNET), 0);
    ASSERT_EQ(std::system("ip link set lo up"), 0);
  }

  /// Tells if the manager at that number knows the provider: then it refuses a second process of
  /// the provider's name.
  static bool knows(const std::string& number) {
    const std::string why =
        refusal([&] { Manager("robot", at(number), std::chrono::milliseconds(20)); });
    return contains(why, "the name is held by");
  }
  /// Returns where the host is, as a manager is told to listen.
  static std::string at(const std::string& number) { return "tcp://" + number + ":7700?insecure"; }

  NameService names_;
  const System::Prepare enter_ = [this] { names_.enter(); };
  System system_{"tcp://operating-room.test:7700?insecure"};
};

TEST_F(HostNames, AConnectedProcessNeedsNoNameService) {
  names_.know("operating-room.test", "127.0.0.1");
  auto manager = system_.managerAt(at("127.0.0.1"));
  const auto provider = system_.provider("robot", enter_);
  ASSERT_EQ(provider->line(), "ready");
  const auto client = system_.client("busy", 500, "auto", enter_);
  ASSERT_EQ(client->line(), "begun");
  ASSERT_EQ(client->line(), "ready");
  ASSERT_TRUE(system_.works(true));

  // The manager ends and comes back where it was, while the name service cannot tell where that is.
  for (const bool silent : {false, true}) {
    silent ? names_.fallSilent() : names_.forget();
    manager->end(SIGKILL);
    EXPECT_TRUE(system_.works(true)) << "connections need neither";
    manager = system_.managerAt(at("127.0.0.1"));
    EXPECT_TRUE(eventually([&] { return knows("127.0.0.1"); })) << "silent: " << silent;
    EXPECT_TRUE(system_.works(true));
  }

  // It moves to another machine, which only the name service tells.
  manager->end(SIGKILL);
  manager = system_.managerAt(at("127.0.0.2"));
  names_.know("operating-room.test", "127.0.0.2");
  EXPECT_TRUE(eventually([&] { return knows("127.0.0.2"); }));
  EXPECT_TRUE(system_.works(true));
  EXPECT_EQ(client->end(SIGTERM), 0);
  EXPECT_EQ(provider->end(SIGTERM), 0);
  expectSoundHistory(system_.history());
}

TEST_F(HostNames, ANewProcessAwaitsTheNameService) {
  const auto manager = system_.managerAt(at("127.0.0.1"));
  names_.fallSilent();
  const auto provider = system_.provider("robot", enter_);
  ASSERT_TRUE(names_.wasAsked());
  names_.know("operating-room.test", "127.0.0.1");
  EXPECT_EQ(provider->line(), "ready");
  EXPECT_EQ(provider->end(SIGTERM), 0);
}

}  // namespace
}  // namespace suture
