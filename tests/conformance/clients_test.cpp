// A provider's component is told of its clients.

#include "conformance/setup.h"

namespace conformance {
namespace {

using Lines = std::vector<std::string>;

/// The provider has a thread in which it is told: it is no device that its client calls directly.
class Clients : public Conformance {
 protected:
  std::string named(const char* news) const {
    return std::string(GetParam().sharesManager() ? "alone" : "client") + ":Console/Arm" + news;
  }
  bool eventuallyTold(const Lines& lines) const {
    return suture::eventually([&] { return arm->clients() == lines; });
  }
};

TEST_P(Clients, EachConnectionAndItsEndAreTold) {
  const Lines first{named(" connected")};
  EXPECT_TRUE(eventuallyTold(first));
  disconnectArm();
  const Lines gone{named(" connected"), named(" closed")};
  EXPECT_TRUE(eventuallyTold(gone));
  connect("Arm", provided());
  settle();
  EXPECT_EQ(arm->clients(), (Lines{named(" connected"), named(" closed"), named(" connected")}))
      << "each once";
}

class WireClientProcesses : public Clients {};

TEST_P(WireClientProcesses, AClientsEndIsToldOnce) {
  EXPECT_TRUE(eventuallyTold({named(" connected")}));
  endClientsProcess();
  const Lines gone{named(" connected"), named(" closed")};
  EXPECT_TRUE(eventuallyTold(gone));
}

INSTANTIATE_TEST_SUITE_P(Lanes, Clients, testing::ValuesIn(laneRows(isQueued)), nameOf);
INSTANTIATE_TEST_SUITE_P(Lanes, WireClientProcesses, testing::ValuesIn(wireRows([](const Row& row) {
                           return !row.sharesManager();
                         })),
                         nameOf);

}  // namespace
}  // namespace conformance
