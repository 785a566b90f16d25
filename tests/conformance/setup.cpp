#include "conformance/setup.h"

#include <suture/component/channel/channel.h>
#include <suture/loop/control_thread.h>
#include <suture/names/global_manager.h>
#include <suture/net/tls/certificate.h>
#include <suture/net/tls/key_maker.h>
#include <unistd.h>

#include "support/patience.h"

namespace conformance {
namespace {

using namespace std::chrono_literals;

std::unique_ptr<Client> makeClient(ClientKind kind) {
  if (kind == ClientKind::Task) return std::make_unique<TaskClient>();
  return std::make_unique<DeviceClient>();
}

}  // namespace

/// Names is a global manager of the test's own.
struct Conformance::Names {
  Names(const std::string& address, const std::string& keys)
      : global(control, address, securityOf(suture::tls::kManagerName, keys)) {}
  suture::loop::ControlThread control;
  suture::GlobalManager global;
};

Conformance::Conformance() {
  if (GetParam().isStepped()) clock.emplace(suture::steppedOptions());
  client = makeClient(GetParam().client);
}

// Two managers in one process are two processes to each other: nothing is shared but the sockets.
void Conformance::SetUp() {
  const Row& row = GetParam();
  if (row.where == Where::TwoNamespaces && geteuid() != 0) {
    GTEST_SKIP() << "only root may make network namespaces";
  }
  arm = std::make_unique<Provider>(row.provider, row.where);  // the first thread is later
  if (row.sharesManager()) {
    arm->start("");
    clientManager_ = &arm->manager();
  } else {
    const std::string keys = row.transport == Transport::Tls ? makeKeys() : "";
    names_ = std::make_unique<Names>(managerAddress(), keys);
    arm->start(names_->global.address(), keys);
    ownClientManager_ = std::make_unique<suture::Manager>("client", names_->global.address(),
                                                          securityOf("client", keys));
    clientManager_ = ownClientManager_.get();
    if (addedLane().name != nullptr) clientManager_->addLane(addedLane().make());
  }
  clientManager_->add("Console", client->component());
  clientManager_->start();
  connect("Arm", provided());
  expectWhereItBelongs();
}

std::string Conformance::makeKeys() const {
  suture::tls::makeKeys(file("keys"), {suture::tls::kManagerName, "provider", "client"});
  return file("keys");
}

std::string Conformance::managerAddress() const {
  const Row& row = GetParam();
  const bool twoMachines = row.where == Where::TwoNamespaces;
  const std::string host = twoMachines ? suture::Cable::kHere : "127.0.0.1";
  switch (row.transport) {
    case Transport::Tcp: return "tcp://" + host + ":0" + (twoMachines ? "?insecure" : "");
    case Transport::Tls: return "tls://" + host + ":0";
    default: return "unix:" + file("manager.sock");
  }
}

void Conformance::expectWhereItBelongs() const {
  const Row& row = GetParam();
  const pid_t process = arm->at([](ArmComponent& one) { return one.answeredBy(); });
  EXPECT_EQ(process == getpid(), row.where == Where::OneProcess) << process;
  const std::string there = suture::Cable::namespaceOf(std::to_string(process));
  EXPECT_EQ(there == suture::Cable::namespaceOf("thread-self"), row.where != Where::TwoNamespaces);
  EXPECT_EQ(channel()->lane, expectedLane());
  if (row.sharesManager()) {
    EXPECT_EQ(channel()->bytesSent, 0u);
  } else {
    EXPECT_TRUE(suture::eventually(
        [&] { return channel()->bytesSent > 100 && channel()->bytesReceived > 0; }));
  }
}

suture::Lane Conformance::askedLane() const {
  switch (GetParam().lane) {
    case BaseLane::Frame: return suture::Lane::Frame;
    case BaseLane::Rpc: return suture::Lane::Rpc;
    case BaseLane::Added: return {addedLane().name};
    default: return suture::Lane::Auto;
  }
}

std::string Conformance::expectedLane() const {
  const char* const names[] = {"local", "shm", "frame", "rpc", addedLane().name};
  const Filter filter = GetParam().filter;
  return std::string(names[static_cast<int>(GetParam().lane)]) + (filter == Filter::None ? ""
                                                                  : filter == Filter::Delay
                                                                      ? "+delay"
                                                                      : "+fault");
}

suture::FaultPlan Conformance::faults() const {
  if (GetParam().filter != Filter::Faults) return {};
  return {.seed = 1, .duplicate = 0.3, .delay = 0.1, .delayLength = 3ms};
}

void Conformance::connect(const std::string& required, const std::string& provided) {
  const bool delayed = GetParam().filter == Filter::Delay || GetParam().filter == Filter::Faults;
  const std::chrono::milliseconds each(delayed ? 2 : 0);
  clientManager_->connect(
      "Console/" + required, (GetParam().sharesManager() ? "PSM/" : "provider:PSM/") + provided,
      {.lane = askedLane(), .delay = {.commands = each, .answers = each, .faults = faults()}});
  const auto eventually = [&](const auto& condition) {
    return suture::eventually([&] {
      bool held = false;
      const auto look = [&](auto& remote) { held = condition(remote); };
      required == "Gripper" ? client->withGripper(look) : client->with(look);
      return held;
    });
  };
  // A client that is in a cycle already takes the connection over in its next one.
  ASSERT_TRUE(eventually([](auto& remote) { return remote.connected(); }));
  // A task sends its events to a new client from its next cycle on: the one that answers a command.
  ASSERT_TRUE(eventually([](auto& remote) {
    const suture::Duration patience = GetParam().isLossy() ? 50ms : 5s;
    const bool answered = remote.distance.start({}).within(patience).has_value();
    EXPECT_TRUE(answered || GetParam().isLossy()) << "the first call on this connection was lost";
    return answered;
  }));
}

void Conformance::disconnectArm() {
  clientManager_->disconnect("Console/Arm");
  // A device looks at its connections only when it uses them.
  EXPECT_TRUE(suture::eventually([&] {
    bool connected = true;
    client->with([&](Arm& remote) { connected = remote.connected(); });
    return !connected;
  }));
}

void Conformance::settle() {
  client->with([](Arm& remote) { EXPECT_TRUE(remote.hold.start().within(suture::kPatience)); });
}

void Conformance::stall() {
  arm->gate().close();
  client->with([](Arm& remote) { EXPECT_TRUE(remote.set_mode(Mode::Disabled)); });
  ASSERT_TRUE(suture::eventually([&] { return arm->gate().hasVisitor(); }));
}

void Conformance::TearDown() {
  if (IsSkipped()) return;
  arm->gate().open();
  if (ownClientManager_ != nullptr) ownClientManager_->stop();
  arm->stop();
}

Conformance::~Conformance() = default;

void Conformance::stopProvider() {
  // On `local` both live in one manager, and only the provider's task is to end.
  if (!GetParam().sharesManager()) return arm->stop();
  arm->at([](ArmComponent& one) { dynamic_cast<suture::Task&>(one.component()).stop(); });
}

std::string nameOf(const testing::TestParamInfo<Row>& info) { return info.param.name(); }

}  // namespace conformance
