// These test the executable suture-manager.

#include <gtest/gtest.h>
#include <suture/manager/manager.h>
#include <suture/names/security.h>
#include <suture/net/tls/key_maker.h>
#include <suture/net/tls/keys.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <vector>

#include "paths.h"
#include "support/child.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

/// A Program is suture-manager, with what it prints, errors too.
class Program final : public Child {
 public:
  explicit Program(const std::string& listen, const std::vector<std::string>& more = {})
      : Child(commandLine(listen, more), [] { dup2(STDOUT_FILENO, STDERR_FILENO); }) {}

 private:
  static std::vector<std::string> commandLine(const std::string& listen,
                                              const std::vector<std::string>& more) {
    std::vector<std::string> line{paths::kSutureManager, "--listen", listen};
    line.insert(line.end(), more.begin(), more.end());
    return line;
  }
};

class SutureManagerTest : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Signals, SutureManagerTest, testing::Values(SIGINT, SIGTERM));

TEST_P(SutureManagerTest, StartsAndEndsCleanlyOnASignal) {
  const TemporaryDirectory directory;
  const std::string address = "unix:" + directory.file("new/manager.sock");
  Program program(address);
  EXPECT_EQ(program.line(), "suture-manager: ready on " + address);
  EXPECT_EQ(program.end(GetParam()), 0);
}

TEST(SutureManager, TellsThePortItPicked) {
  Program program("tcp://127.0.0.1:0");
  const std::string line = program.line();
  EXPECT_TRUE(line.starts_with("suture-manager: ready on tcp://127.0.0.1:")) << line;
  EXPECT_FALSE(line.ends_with(":0")) << line;
}

TEST(SutureManager, AnAddressInUseIsAnError) {
  const TemporaryDirectory directory;
  const std::string address = "unix:" + directory.file("manager.sock");
  Program first(address);
  first.line();
  Program second(address);
  const std::string line = second.line();
  EXPECT_NE(line.find("listen at " + address), std::string::npos) << line;
  EXPECT_NE(line.find("another process listens there"), std::string::npos) << line;
  EXPECT_EQ(second.end(0), 1);
}

TEST(SutureManager, AnImpossibleFolderIsAnError) {
  Program program("unix:/nowhere/at/all/manager.sock");
  EXPECT_EQ(program.line(),
            "suture-manager: make the directory /nowhere/at/all: No such file or directory. "
            "Choose another with --listen.");
  EXPECT_EQ(program.end(0), 1);
}

TEST(SutureManager, TakesOverFromOneThatWasKilled) {
  const TemporaryDirectory directory;
  const std::string address = "unix:" + directory.file("manager.sock");
  {
    Program first(address);
    first.line();
    EXPECT_EQ(first.end(SIGKILL), -SIGKILL);
  }
  Program second(address);
  EXPECT_EQ(second.line(), "suture-manager: ready on " + address);
}

TEST(SutureManager, ListensForTlsWithItsKeys) {
  const TemporaryDirectory directory;
  const std::string keys = directory.file("keys");
  tls::makeKeys(keys, {tls::kManagerName, "left"});
  Program program("tls://127.0.0.1:0", {"--keys", keys});
  const std::string line = program.line(), ready = "suture-manager: ready on ";
  ASSERT_TRUE(line.starts_with(ready + "tls://127.0.0.1:")) << line;
  const Manager left("left", line.substr(ready.size()),
                     {.keys = std::make_shared<const tls::Keys>(keys, "left")});
  EXPECT_EQ(left.missingGlobalManager(), "");
}

TEST(SutureManager, TlsWithoutKeysIsRefused) {
  Program program("tls://127.0.0.1:0");
  const std::string line = program.line();
  EXPECT_NE(line.find("this process has no keys. Make them with suture keys"), std::string::npos)
      << line;
  EXPECT_EQ(program.end(0), 1);
}

TEST(SutureManager, PlainTcpHasToBeAskedFor) {
  Program program("tcp://0.0.0.0:0?insecure");
  const std::string line = program.line();
  EXPECT_TRUE(line.starts_with("suture-manager: ready on tcp://0.0.0.0:")) << line;
}

TEST(SutureManager, OpensItsSocketToNamedUsers) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("m.sock");
  struct stat status {};
  {
    Program program("unix:" + file);
    program.line();
    ASSERT_EQ(stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0600u);
    program.end(SIGTERM);
  }
  Program program("unix:" + file, {"--user", "1234"});
  program.line();
  ASSERT_EQ(stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0666u);
  const Manager ours("left", "unix:" + file);
  EXPECT_EQ(ours.missingGlobalManager(), "");
}

TEST(SutureManager, PlainTcpToTheOutsideIsRefused) {
  Program program("tcp://0.0.0.0:0");
  const std::string line = program.line();
  EXPECT_NE(line.find("not a loopback"), std::string::npos) << line;
  EXPECT_EQ(program.end(0), 1);
}

}  // namespace
}  // namespace suture
