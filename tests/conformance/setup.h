#pragma once
// These are a provider and a client, connected over the lane under test.

#include <gtest/gtest.h>
#include <suture/component/sleep.h>
#include <suture/manager/manager.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "conformance/ends/client.h"
#include "conformance/ends/provider.h"
#include "conformance/rows.h"
#include "support/eventually.h"
#include "support/patience.h"
#include "support/stepped.h"
#include "support/temporary_directory.h"

namespace conformance {

/// `arm` and `client` are connected when the scenario begins.
class Conformance : public testing::TestWithParam<Row> {
 protected:
  Conformance();
  ~Conformance() override;
  void SetUp() override;
  void TearDown() override;

  /// Connects another required interface of the client.
  void connect(const std::string& required, const std::string& provided);
  /// Returns when the client has let go of the connection of its "Arm".
  void disconnectArm();
  /// Makes the client's process go away; only where the ends do not share a manager.
  void endClientsProcess() { ownClientManager_.reset(); }

  bool eventuallyTaken(const std::vector<std::string>& lines) {
    return suture::eventually([&] { return arm->taken() == lines; });
  }
  /// Returns when the provider knows what the client did last: it has executed a command sent
  /// later.
  void settle();
  /// Holds the provider inside a handler until the gate is opened.
  void stall();
  /// Returns the connection as the client's process sees it.
  std::shared_ptr<suture::Channel> channel() const { return clientManager_->channels().at(0); }
  /// Returns what that process reports of its commands on the connection.
  suture::HistorySums clientsSums() const {
    return sumsOf(reportOf(*clientManager_, suture::ConnectionEnd::Client),
                  clientManager_->incarnation());
  }

  /// Names the provided interface that the client's "Arm" is connected to.
  virtual const char* provided() const { return "Arm"; }
  /// Says what befalls each message.
  virtual suture::FaultPlan faults() const;
  /// The provider's process goes away; its component object stays.
  void stopProvider();
  /// Names a file in a folder of this test.
  std::string file(const std::string& name) const { return directory_.file(name); }

  std::optional<suture::TestClock> clock;  ///< if the row can have one
  std::unique_ptr<Provider> arm;
  std::unique_ptr<Client> client;

 private:
  struct Names;

  /// Makes those of the processes of this test, and returns their folder.
  std::string makeKeys() const;
  std::string managerAddress() const;
  /// Returns the lane to ask for; shared memory needs no asking.
  suture::Lane askedLane() const;
  /// The connection's lane must be called so.
  std::string expectedLane() const;
  void expectWhereItBelongs() const;

  suture::TemporaryDirectory directory_;
  std::unique_ptr<Names> names_;
  std::unique_ptr<suture::Manager> ownClientManager_;
  suture::Manager* clientManager_ = nullptr;  // the provider's on `local`
};

std::string nameOf(const testing::TestParamInfo<Row>& info);

/// Waits, in the client's own thread inside of Client::with(), for what rings the client, and
/// handles no event and begins no cycle meanwhile. Returns false after kPatience.
template <class Condition>
bool awaitInPlace(suture::RequiredBase& remote, const Condition& condition) {
  bool held = false;
  suture::sleepUntil(remote.owner(), suture::now() + suture::kPatience,
                     [&] { return held = condition(); });
  return held;
}

inline PoseStamped poseAt(double x) {
  PoseStamped pose;
  pose.pose.translation().x() = x;
  pose.stamp = suture::now();
  pose.valid = true;
  return pose;
}

}  // namespace conformance
