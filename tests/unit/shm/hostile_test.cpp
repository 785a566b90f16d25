// The other process writes anything anywhere into the memory that it shares with this one.
#include <gtest/gtest.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>
#include <suture/lane/shm/shared_channel.h>
#include <suture/record/json_lines.h>
#include <suture/record/state_collector.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <vector>

#include "reference/still_arm.h"
#include "support/eventually.h"
#include "support/temporary_directory.h"
#include "unit/component/arm_client.h"

namespace suture {
namespace {

using namespace std::chrono_literals;
using reference::ArmLike;
using reference::JointState;
using reference::Mode;
using reference::PoseStamped;

/// Keeps what no handler may ever see.
struct Psm final : PeriodicTask, StillArm {
  Psm() : PeriodicTask({.period = 1ms}) {}
  ~Psm() override { stop(); }
  void run() override {
    port.emit().stopped();
    port.emit().arrived({});
  }
  void servo_cp(const PoseStamped& goal) override { note(goal.pose.matrix().allFinite()); }
  void servo_jp(const JointState& goal) override {
    note(goal.position.size() <= 8 && goal.name.size() <= 8);
    for (const double one : goal.position) note(std::isfinite(one));
  }
  void set_mode(Mode mode) override { note(mode == Mode::Disabled || mode == Mode::Enabled); }
  bool move(const PoseStamped&, double speed, const std::string& reason) override {
    note(speed >= 0 && speed <= 1 && reason.size() < 256);
    return true;
  }
  void note(bool valid) {
    ++handled;
    if (!valid) ++invalid;
  }
  std::atomic<std::uint64_t> handled{0}, invalid{0};
  Provided<ArmLike> port{*this, "Arm", *this};
};

/// Uses all that there is.
struct Teleop final : PeriodicTask {
  Teleop() : PeriodicTask({.period = 1ms}) {}
  ~Teleop() override { stop(); }
  void onStart() override {
    slave.on().mode([this](Mode mode) { note(mode == Mode::Disabled || mode == Mode::Enabled); });
    slave.on().arrived([this](const PoseStamped& pose) { note(pose.pose.matrix().allFinite()); });
    slave.on().stopped([this] { ++heard; });
  }
  void run() override {
    (void)slave.servo_cp({});
    (void)slave.servo_jp({{"a", "b"}, {1, 2}});
    (void)slave.set_mode(Mode::Enabled);
    const auto read = slave.measured_cp();
    poseError = read ? Errc{} : read.error();
    if (read) note(read->pose.matrix().allFinite());
    (void)slave.measured_js();
    if (call.poll() != nullptr) call = slave.move.start({}, 0.5, "test");
    if (const auto* const answer = question.poll(); answer != nullptr) {
      if (!*answer) distanceError = answer->error();
      question = slave.distance.start({});
    }
  }
  void note(bool valid) {
    ++heard;
    if (!valid) ++invalid;
  }
  std::atomic<std::uint64_t> heard{0}, invalid{0};
  Required<ArmLike> slave{*this, "Slave"};
  decltype(std::declval<Required<ArmLike>&>().move.start({}, 0, "")) call{Errc::NotYet};
  decltype(std::declval<Required<ArmLike>&>().distance.start({})) question{Errc::NotYet};
  std::atomic<Errc> poseError{}, distanceError{};  // why the last had no value
};

/// A Scribbler is another process, which has the memory and no good intentions.
class Scribbler {
 public:
  Scribbler(const MemoryBlock& block, unsigned seed) : pid_(fork()) {
    if (pid_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // also if the test crashes
    std::minstd_rand random(seed);
    for (;;) {
      const std::uint64_t values[] = {0,
                                      1,
                                      ~std::uint64_t{0},
                                      0x7ff8000000000000,
                                      random(),
                                      random() % 64,
                                      std::uint64_t{random()} << 32,
                                      0xff};
      const std::uint64_t value = values[random() % std::size(values)];
      std::memcpy(block.data() + random() % (block.size() / 8) * 8, &value, 8);
      usleep(20);
    }
  }
  ~Scribbler() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Scribbler(const Scribbler&) = delete;
  Scribbler& operator=(const Scribbler&) = delete;

 private:
  const pid_t pid_;
};

/// Maps them as another process does.
shm::SharedParts mappedAgain(const shm::SharedParts& parts, const InterfaceInfo& contract) {
  using Others = MemoryBlock::Others;
  shm::SharedParts mapped = parts;
  const auto again = [](const MemoryBlock& block, std::size_t size, Others others) {
    return MemoryBlock::open(block.descriptor(), size, others);
  };
  mapped.channel = again(*parts.channel, shm::channelBytes(contract), Others::Write);
  mapped.state = again(*parts.state, shm::stateBytes(parts), Others::Read);
  mapped.bell = again(*parts.bell, sizeof(std::uint64_t), Others::Write);
  return mapped;
}

/// Holds both ends of a connection, each as its process maps the memory; no end is attached.
struct SharedConnection {
  Psm psm;
  Teleop teleop;
  const std::shared_ptr<rt::Doorbell> watcher = std::make_shared<rt::Doorbell>();
  const InterfaceInfo& contract = interfaceInfo<ArmLike>();
  shm::SharedOffer offer = shm::offerShared({.provided = psm.port,
                                             .contract = contract,
                                             .terms = {.name = "test"},
                                             .events = ~EventSet{0},
                                             .provider = psm.sharedDoorbell()},
                                            teleop.doorbell().share(), watcher);
  std::shared_ptr<Channel> client = shm::takeShared(
      {.contract = contract, .terms = {.name = "test"}, .client = teleop.sharedDoorbell()},
      mappedAgain(offer.parts, contract));
};

class HostileProvider : public SharedConnection, public testing::Test {};

TEST_F(HostileProvider, EmitsWhatNoHandlerSees) {
  teleop.slave.attach(client);
  teleop.start();
  constexpr std::uint16_t kArrived = 1, kStopped = 2;
  const std::vector notANumber(contract.events[kArrived].payloadSize, std::byte{0xff});
  offer.channel->events.push(kArrived, now(), notANumber);
  offer.channel->events.push(kStopped, now(), {});
  client->ends.client->ring(rt::RungFor::Arrival);
  EXPECT_TRUE(eventually([&] { return teleop.heard > 0; }));
  teleop.stop();
  EXPECT_EQ(teleop.heard, 1u);
  EXPECT_EQ(teleop.invalid, 0u);
  EXPECT_EQ(client->events.dropped(), 1u);
  EXPECT_EQ(client->lastInvalid.read().text(), "arrived.pose");
}

TEST_F(HostileProvider, PublishesWhatNoClientSees) {
  teleop.slave.attach(client);
  teleop.start();
  rt::StateTable& state = *offer.channel->state;
  std::memset(state.draft(0), 0xff, state.columnSize(0));
  state.publish(now(), {.valid = 1});
  EXPECT_TRUE(eventually([&] { return teleop.poseError == Errc::Invalid; }));
  EXPECT_EQ(client->lastInvalid.read().text(), "measured_cp.pose");
  std::memset(state.draft(0), 0, state.columnSize(0));
  state.publish(now(), {.valid = 1});
  EXPECT_TRUE(eventually([&] { return teleop.poseError == Errc{}; }));
  teleop.stop();
  EXPECT_EQ(teleop.invalid, 0u);
}

/// Publishes rows that only look as if they were of this contract.
class CollectedProvider : public HostileProvider {
 protected:
  CollectedProvider() {
    collector_.required().front()->attach(client);
    collector_.start();
  }
  /// Returns what the recording says of measured_js when its row is `slot`.
  nlohmann::json recorded(const reference::JointStateSlot& slot) {
    EXPECT_TRUE(eventually([&] { return client->state->demand() != 0; }));
    constexpr unsigned kMeasuredJs = 1;
    rt::StateTable& state = *offer.channel->state;
    std::memcpy(state.draft(kMeasuredJs), &slot, sizeof(slot));
    state.publish(now(), {.valid = 1 << kMeasuredJs});
    EXPECT_TRUE(eventually([&] { return collector_.counts().collected == 1; }));
    collector_.stop();
    sink_.flush();
    std::ifstream file(directory_.file("arm.jsonl"));
    return nlohmann::json::parse(file).at("measured_js");
  }

 private:
  const TemporaryDirectory directory_;
  JsonLines sink_{directory_.file("arm.jsonl")};
  StateCollector collector_{contract, {.reads = {"measured_js"}, .period = 1ms}, sink_};
};

TEST_F(CollectedProvider, WritesNoNumbersIntoARecording) {
  reference::JointStateSlot slot{};
  std::memset(&slot, 0xff, sizeof(slot));
  EXPECT_EQ(recorded(slot), nullptr);
  EXPECT_EQ(client->lastInvalid.read().text(), "measured_js.position");
}

TEST_F(CollectedProvider, ClaimsLongerTextsThanHaveRoom) {
  reference::JointStateSlot slot{};
  slot.name.size = ~0u;
  slot.name.data[0].size = ~0u;
  const nlohmann::json names = recorded(slot).at("name");
  EXPECT_EQ(names.size(), std::size(slot.name.data));
  EXPECT_EQ(names[0].get<std::string>().size(), std::size(slot.name.data[0].data));
}

TEST_F(HostileProvider, AnswersWhatNoClientSees) {
  teleop.slave.attach(client);
  teleop.start();
  const auto answerAll = [this] {
    rt::Mailbox& commands = offer.channel->commands;
    commands.fixCut();
    while (const rt::CommandRecord* const record = commands.next()) {
      const std::uint32_t size = contract.commands[record->command].resultSize;
      if (record->call != 0 && contract.commands[record->command].name == std::string("distance")) {
        offer.channel->provider.reply(record->call, {.size = size}, [size](std::byte* result) {
          std::memset(result, 0xff, size);  // no number
          return Errc{};
        });
      }
      commands.pop();
    }
  };
  EXPECT_TRUE(eventually([&] {
    answerAll();
    return teleop.distanceError == Errc::Invalid;
  }));
  teleop.stop();
  EXPECT_EQ(client->lastInvalid.read().text(), "distance");
}

// A newer provider may have errors that this build does not know: the command may have run then.
TEST_F(HostileProvider, AnswersWithAnErrorOfItsOwn) {
  ArmClient asking;
  asking.arm.attach(client);
  auto call = asking.arm.distance.start({});
  ASSERT_FALSE(call.poll());
  rt::Mailbox& commands = offer.channel->commands;
  commands.fixCut();
  const rt::CommandRecord* const record = commands.next();
  ASSERT_NE(record, nullptr);
  offer.channel->provider.replyError(record->call, static_cast<Errc>(77));
  ASSERT_TRUE(call.poll());
  EXPECT_EQ(call.poll()->error(), Errc::OutcomeUnknown);
}

class HostileClient : public SharedConnection, public testing::Test {};

TEST_F(HostileClient, SendsWhatNoHandlerSees) {
  psm.port.attach(offer.channel);
  psm.start();
  constexpr std::uint16_t kServoJp = 1;
  const Result<std::byte*> arguments = client->commands.claim(kServoJp, now(), 0);
  ASSERT_TRUE(arguments);
  std::memset(*arguments, 0xff, contract.commands[kServoJp].argumentsSize);
  client->commands.commit();
  client->ends.provider->ring();
  EXPECT_TRUE(eventually([&] { return !offer.channel->lastInvalid.read().empty(); }));
  psm.stop();
  EXPECT_EQ(offer.channel->lastInvalid.read().text(), "servo_jp.goal.position");
  EXPECT_EQ(psm.handled, 0u);
}

class HostileMemory : public SharedConnection, public testing::TestWithParam<unsigned> {};

TEST_P(HostileMemory, HarmsNoProviderAndNoClient) {
  psm.port.attach(offer.channel);
  teleop.slave.attach(client);
  psm.start();
  teleop.start();
  ASSERT_TRUE(eventually([&] { return psm.handled > 10 && teleop.heard > 10; }));
  {
    const Scribbler scribbler(*offer.parts.channel, GetParam());
    const std::uint64_t cycles = psm.statistics().cycles, clients = teleop.statistics().cycles;
    ASSERT_TRUE(eventually([&] {
      return psm.statistics().cycles > cycles + 500 && teleop.statistics().cycles > clients + 500;
    }));
  }
  EXPECT_EQ(psm.state(), ComponentState::Running) << psm.fault();
  EXPECT_EQ(teleop.state(), ComponentState::Running) << teleop.fault();
  EXPECT_EQ(psm.invalid, 0u) << "of " << psm.handled;
  EXPECT_EQ(teleop.invalid, 0u) << "of " << teleop.heard;
  std::printf("seed %u: %llu commands handled\n", GetParam(),
              static_cast<unsigned long long>(psm.handled));
}

INSTANTIATE_TEST_SUITE_P(Seeds, HostileMemory, testing::Range(1u, 9u));

}  // namespace
}  // namespace suture
