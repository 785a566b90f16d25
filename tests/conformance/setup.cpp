#include "conformance/setup.h"

#include <suture/component/channel.h>
#include <suture/manager/global_manager.h>
#include <suture/transport/rpc/control_thread.h>
#include <unistd.h>

#include <cstdlib>

#include "support/eventually.h"

namespace conformance {
namespace {

std::unique_ptr<Client> makeClient(ClientKind kind) {
  if (kind == ClientKind::Task) return std::make_unique<TaskClient>();
  return std::make_unique<DeviceClient>();
}

}  // namespace

/// A global manager of the test's own.
struct Conformance::Names {
  explicit Names(const std::string& address) : global(control, address) {}
  suture::rpc::ControlThread control;
  suture::GlobalManager global;
};

Conformance::Conformance() : client(makeClient(std::get<2>(GetParam()))) {}

// Two managers in one process are two processes to each other: nothing is shared but the sockets.
void Conformance::SetUp() {
  if (where() == Where::TwoNamespaces && geteuid() != 0) {
    GTEST_SKIP() << "only root may make network namespaces";
  }
  arm = std::make_unique<Provider>(std::get<1>(GetParam()), where());  // the first thread is later
  if (shareManager()) {
    arm->start("");
    clientManager_ = &arm->manager();
  } else {
    names_ = std::make_unique<Names>(managerAddress());
    arm->start(names_->global.address());
    ownClientManager_ = std::make_unique<suture::Manager>("client", names_->global.address());
    clientManager_ = ownClientManager_.get();
  }
  clientManager_->add("Console", client->component());
  clientManager_->start();
  connect("Arm", provided());
  expectWhereItBelongs();
}

std::string Conformance::managerAddress() const {
  if (where() == Where::TwoNamespaces)
    return std::string("tcp://") + suture::Cable::kHere + ":0?insecure";
  const LaneUnderTest lane = std::get<0>(GetParam());
  const bool tcp = lane == LaneUnderTest::RpcTcp || lane == LaneUnderTest::FrameTcp;
  return tcp ? "tcp://127.0.0.1:0" : "unix:" + directory_.file("manager.sock");
}

void Conformance::expectWhereItBelongs() const {
  const pid_t process = arm->at([](ArmComponent& one) { return one.answeredBy(); });
  EXPECT_EQ(process == getpid(), where() == Where::OneProcess) << process;
  const std::string there = suture::Cable::namespaceOf(std::to_string(process));
  EXPECT_EQ(there == suture::Cable::namespaceOf("thread-self"), where() != Where::TwoNamespaces);
  const std::string lane = expectedLane();
  EXPECT_EQ(channel()->lane, isFaulty() ? lane + "+fault" : isDelayed() ? lane + "+delay" : lane);
  if (shareManager()) {
    EXPECT_EQ(channel()->bytesSent, 0u);
  } else {
    EXPECT_TRUE(suture::eventually(
        [&] { return channel()->bytesSent > 100 && channel()->bytesReceived > 0; }));
  }
}

suture::Lane Conformance::askedLane() const {
  switch (std::get<0>(GetParam())) {
    case LaneUnderTest::FrameUnix:
    case LaneUnderTest::FrameTcp:
    case LaneUnderTest::DelayedFrame: return suture::Lane::Frame;
    case LaneUnderTest::RpcUnix:
    case LaneUnderTest::RpcTcp:
    case LaneUnderTest::DelayedRpc: return suture::Lane::Rpc;
    default: return suture::Lane::Auto;
  }
}

std::string Conformance::expectedLane() const {
  if (shareManager()) return "local";
  return askedLane() == suture::Lane::Auto ? "shm" : toString(askedLane());
}

void Conformance::connect(const std::string& required, const std::string& provided) {
  const std::chrono::milliseconds each(isDelayed() ? 2 : 0);
  suture::FaultPlan faults;
  if (isFaulty()) faults = {.seed = 1, .duplicate = 0.3, .delay = 0.1};
  faults.delayLength = std::chrono::milliseconds(3);
  clientManager_->connect(
      "Console/" + required, (shareManager() ? "PSM/" : "provider:PSM/") + provided, askedLane(),
      suture::Manager::kDefaultPatience, {.commands = each, .answers = each, .faults = faults});
  const auto with = [&](const std::function<void(Arm&)>& work) {
    if (required == "Gripper") return client->withGripper(work);
    client->with(work);
  };
  // A client that is in a cycle already takes the connection over in its next one.
  ASSERT_TRUE(suture::eventually([&] {
    bool connected = false;
    with([&](Arm& remote) { connected = remote.connected(); });
    return connected;
  }));
  // A task sends its events to a new client from its next cycle on: the one that answers a command.
  bool answered = false;
  with([&](Arm& remote) {
    answered = remote.distance.start({}).within(std::chrono::seconds(5)).has_value();
  });
  ASSERT_TRUE(answered);
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
  if (!shareManager()) return arm->stop();
  arm->at([](ArmComponent& one) { dynamic_cast<suture::Task&>(one.component()).stop(); });
}

std::string nameOf(const testing::TestParamInfo<Combination>& info) {
  static constexpr const char* kLanes[] = {
      "Local",        "Shm",        "FrameUnix",    "FrameTcp",   "RpcUnix",  "RpcTcp",
      "DelayedLocal", "DelayedShm", "DelayedFrame", "DelayedRpc", "FaultyShm"};
  static constexpr const char* kProviders[] = {"Periodic", "EventDriven", "Device"};
  static constexpr const char* kClients[] = {"Task", "Device"};
  static constexpr const char* kWhere[] = {"", "InTwoProcesses", "InTwoNamespaces"};
  const auto [lane, provider, client, where] = info.param;
  return std::string(kLanes[static_cast<int>(lane)]) + "To" +
         kProviders[static_cast<int>(provider)] + "From" + kClients[static_cast<int>(client)] +
         kWhere[static_cast<int>(where)];
}

std::vector<Combination> allCombinations() {
  using enum LaneUnderTest;
  std::vector<Combination> all;
  for (const auto provider :
       {ProviderKind::Periodic, ProviderKind::EventDriven, ProviderKind::Device}) {
    for (const auto lane : {Local, Shm, FrameUnix, FrameTcp, RpcUnix, RpcTcp, DelayedLocal,
                            DelayedShm, DelayedFrame, DelayedRpc, FaultyShm}) {
      for (const auto client : {ClientKind::Task, ClientKind::Device}) {
        all.emplace_back(lane, provider, client, Where::OneProcess);
      }
    }
    for (const auto lane : {Shm, FrameUnix, FrameTcp, RpcUnix, RpcTcp, FaultyShm}) {
      all.emplace_back(lane, provider, ClientKind::Task, Where::TwoProcesses);
    }
    for (const auto lane : {FrameTcp, RpcTcp}) {
      all.emplace_back(lane, provider, ClientKind::Task, Where::TwoNamespaces);
    }
  }
  return all;
}

std::vector<Combination> combinations(
    const std::function<bool(LaneUnderTest, ProviderKind)>& keep) {
  std::vector<Combination> kept = allCombinations();
  std::erase_if(kept, [&](const Combination& one) {
    return !keep(std::get<LaneUnderTest>(one), std::get<ProviderKind>(one));
  });
  return kept;
}

}  // namespace conformance
