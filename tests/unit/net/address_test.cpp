#include <gtest/gtest.h>
#include <suture/net/address.h>

#include "support/refusal.h"

namespace suture::net {
namespace {

std::string errorOf(const std::string& text) {
  try {
    return "accepted as " + Address::parse(text).text();
  } catch (const SetupError& error) {
    return error.what();
  }
}

TEST(Address, ParsesWhatItPrints) {
  for (const char* text :
       {"unix:/tmp/a.sock", "tcp://127.0.0.1:7700", "tcp://[::1]:80", "tcp://127.1.2.3:0",
        "tls://192.168.0.1:7700", "tls://[fe80::1]:1", "tls://0.0.0.0:0",
        "tcp://192.168.0.1:7700?insecure", "tcp://[2001:db8::1]:7?insecure",
        "tls://robot-2.local:7700", "tls://7dof-arm.local:7700", "tcp://robot:7700?insecure"}) {
    EXPECT_EQ(Address::parse(text).text(), text);
  }
  EXPECT_EQ(Address::parse("tcp://localhost:1").text(), "tcp://127.0.0.1:1");
}

TEST(Address, EveryRefusalNamesItsReason) {
  const std::pair<std::string, std::string> cases[] = {
      {"manager:7700", "it begins with neither unix:, tls:// nor tcp://. Write unix:/path"},
      {"unix:", "it has no path. Write unix:/path/to/socket."},
      {"tcp://127.0.0.1", "it has no port between 0 and 65535. Write tcp://127.0.0.1:7700."},
      {"tcp://127.0.0.1:", "no port"},
      {"tcp://127.0.0.1:77x", "no port"},
      {"tcp://127.0.0.1:70000", "no port"},
      {"tcp://192.168.0.1:7700",
       "plain TCP carries no proof of who is talking, and this is not a loopback address. Use tls"},
      {"tcp://0.0.0.0:7700", "not a loopback"},
      {"tcp://[fe80::1]:7700", "not a loopback"},
      {"tcp://manager:7700", "not a loopback"},
      {"tls://:7700", "neither a number nor a name"},
      {"tls://127.1:7700", "neither a number nor a name"},
      {"tls://0x7f.1:7700", "neither a number nor a name"},
      {"tls://a b:7700", "neither a number nor a name"},
      {"tls://" + std::string(254, 'a') + ":7700", "neither a number nor a name"},
      {"tls://192.168.0.1", "no port"},
      {"tls://192.168.0.1:7700?insecure", "no port"},
      {"tcp://192.168.0.1:7700?secure", "no port"},
      {"tcp://192.168.0.1:7700", "add ?insecure"},
      {"unix:/a,unix:/b", "its path has a comma, which separates addresses. Name one"},
  };
  for (const auto& [text, reason] : cases) {
    const std::string error = errorOf(text);
    EXPECT_NE(error.find("'" + text + "'"), std::string::npos) << error;
    EXPECT_NE(error.find(reason), std::string::npos) << error;
  }
}

TEST(Address, ATooLongPathIsAnError) {
  const std::string error = errorOf("unix:/" + std::string(107, 'x'));
  EXPECT_NE(error.find("its path has 108 characters and a socket's may have 107. Choose a shorter "
                       "directory"),
            std::string::npos)
      << error;
  EXPECT_TRUE(errorOf("unix:/" + std::string(106, 'x')).starts_with("accepted"));
}

TEST(Address, AJoinedPathMustFitToo) {
  Address address;
  address.path = "/" + std::string(106, 'x');
  const SocketAddress place(address);
  EXPECT_LE(place.length, sizeof(sockaddr_un));
  for (const std::size_t length : {108u, 109u, 126u, 4096u}) {
    address.path = "/" + std::string(length - 1, 'x');
    EXPECT_EQ(refusal([&] { const SocketAddress none(address); }),
              "use the address 'unix:" + address.path + "': its path has " +
                  std::to_string(length) +
                  " characters and a socket's may have 107. Choose a shorter directory for the "
                  "manager's socket, for example under /tmp: processes listen there too.");
  }
}

TEST(Address, OnlyANumberLeadsToASocket) {
  const Address name = Address::parse("tls://robot.local:7700");
  EXPECT_EQ(refusal([&] { const SocketAddress place(name); }),
            "use the address 'tls://robot.local:7700': its host is a name. Use the host's number.");
}

/// Returns what a list of addresses is refused with; "" if it is taken.
std::string errorOfAll(const std::string& text) {
  try {
    parseAddresses(text);
    return "";
  } catch (const SetupError& error) {
    return error.what();
  }
}

TEST(Addresses, AreOneOrSeveral) {
  EXPECT_EQ(parseAddresses("unix:/a").size(), 1u);
  const auto both = parseAddresses("tls://10.0.0.1:7700,tls://10.0.0.2:7701");
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].text(), "tls://10.0.0.1:7700");
  EXPECT_EQ(both[1].text(), "tls://10.0.0.2:7701");
}

TEST(Addresses, EveryListedAddressIsChecked) {
  for (const std::string text : {"", ",", "unix:/a,", ",unix:/a", "unix:/a,/b"}) {
    EXPECT_NE(errorOfAll(text).find("begins with neither"), std::string::npos) << text;
  }
}

TEST(Addresses, AListOfSeveralKindsIsRefused) {
  for (const std::string text :
       {"tls://10.0.0.1:7700,tcp://127.0.0.1:7700", "unix:/a,tls://[::1]:1",
        "tcp://127.0.0.1:1,tcp://10.0.0.1:1?insecure"}) {
    EXPECT_NE(errorOfAll(text).find("differ in kind"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace suture::net
