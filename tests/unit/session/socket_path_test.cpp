// A process listens next to its manager, in a folder whose name it did not choose.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <kj/io.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/net/socket.h>
#include <sys/file.h>
#include <sys/socket.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/contains.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace suture {
namespace {

constexpr std::size_t kLongest = 107;  // a socket's path may not be longer

// Its name is part of the path, so it must not lead into another folder.
TEST(SocketPath, APathIsNoProcessName) {
  const TemporaryDirectory directory;
  loop::ControlThread control;
  const GlobalManager names(control, "unix:" + directory.file("m.sock"));
  for (const std::string name : {"a/b", "/a", "", "a:b"}) {
    EXPECT_EQ(refusal([&] { Manager process(name, names.address()); }),
              "register process '" + name +
                  "': a name has 1 to 100 characters, none of them ':', '/', a space or a control "
                  "character. Choose another name.");
  }
}

TEST(SocketPath, ATooLongOwnPathIsTold) {
  const TemporaryDirectory directory;
  const std::string tail = "/m.sock";
  const std::size_t room = kLongest - directory.path().string().size() - tail.size() - 1;
  const std::string folder = directory.file(std::string(room, 'f'));
  std::filesystem::create_directory(folder);
  loop::ControlThread control;
  const GlobalManager names(control, "unix:" + folder + tail);
  for (const std::size_t length : {12u, 40u, 100u}) {
    const std::string error =
        refusal([&] { Manager process(std::string(length, 'p'), names.address()); });
    EXPECT_TRUE(contains(error, " characters and a socket's may have 107. Choose a shorter"))
        << length << ": " << error;
  }
  std::size_t files = 0;
  for (const auto& one : std::filesystem::directory_iterator(folder)) {
    if (one.path().filename() != "m.sock") ++files;
  }
  EXPECT_EQ(files, 0u) << "a socket of another name stays behind";
}

/// Leaves a socket behind, as a process does that is killed.
void leaveSocket(const std::string& path) {
  net::Address address;
  address.path = path;
  const kj::AutoCloseFd bound(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const net::SocketAddress target(address);
  EXPECT_EQ(bind(bound, target.get(), target.length), 0);
}

// The numbers are larger than the kernel gives to a process.
TEST(SocketPath, LeftoversOfItsNameAreRemoved) {
  const TemporaryDirectory directory;
  const std::string killed = directory.file("arm.99999998.sock"),
                    locked = directory.file("arm.99999999.sock.bind"),
                    begun = directory.file("arm.99999997.sock"),
                    other = directory.file("arm.tool.99999999.sock.bind");
  leaveSocket(killed);
  std::ofstream(locked) << "";
  std::ofstream(other) << "";
  leaveSocket(begun);
  const kj::AutoCloseFd held(open((begun + ".bind").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  ASSERT_EQ(flock(held, LOCK_EX), 0);
  loop::ControlThread control;
  const GlobalManager names(control, "unix:" + directory.file("m.sock"));
  const Manager process("arm", names.address());
  EXPECT_FALSE(std::filesystem::exists(killed));
  EXPECT_FALSE(std::filesystem::exists(killed + ".bind"));
  EXPECT_FALSE(std::filesystem::exists(locked)) << "a process died while it began to listen";
  EXPECT_TRUE(std::filesystem::exists(begun)) << "an unseen process begins to listen there";
  EXPECT_TRUE(std::filesystem::exists(begun + ".bind"));
  EXPECT_TRUE(std::filesystem::exists(other)) << "the process has another name";
}

}  // namespace
}  // namespace suture
