// A port offers the standard messages, a contract that derives from them sends them, and clients
// hear them here and over Cap'n Proto RPC.
#include <gtest/gtest.h>
#include <suture/component/channel/channel.h>
#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/loop/control_thread.h>
#include <suture/manager/manager.h>
#include <suture/names/global_manager.h>
#include <suture/standard/message_port.h>

#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "support/eventually.h"
#include "unit/contracts/lamp.suture.h"

namespace {

using namespace std::chrono_literals;
using suture::Lane;
using suture::Message;

TEST(MessageDraft, KeepsAWholeText) {
  suture::MessageDraft draft;
  const Message& message = draft.write(std::string(255, 'x'), 7, 3);
  EXPECT_EQ(message.text, std::string(255, 'x'));
  EXPECT_EQ(message.code, 7u);
  EXPECT_EQ(message.counter, 3u);
  EXPECT_LE(suture::now() - message.stamp, 10s);
}

TEST(MessageDraft, CutsALongText) {
  suture::MessageDraft draft;
  EXPECT_EQ(draft.write(std::string(256, 'x'), 0, 1).text, std::string(252, 'x') + "...");
  // Each accent has two bytes, so the one that would be halved goes.
  std::string accents = "x";
  for (int i = 0; i < 200; ++i) accents += "\u00e9";
  const std::string& cut = draft.write(accents, 0, 2).text;
  EXPECT_EQ(cut, accents.substr(0, 251) + "...");
  EXPECT_EQ(draft.write("short again", 0, 3).text, "short again");
}

/// Says what it is told to, in its own thread.
class Speaker final : public suture::EventTask {
 public:
  Speaker() : EventTask({}) {}
  ~Speaker() override { stop(); }

  void say(std::string text) {
    const std::lock_guard lock(mutex_);
    texts_.push_back(std::move(text));
    doorbell().ring();
  }
  bool silent() const {
    const std::lock_guard lock(mutex_);
    return texts_.empty();
  }

 private:
  void run() override {
    const std::lock_guard lock(mutex_);
    for (const std::string& text : texts_) {
      messages_.status(text);
      messages_.warning(text, 4);
      messages_.error(text);
    }
    texts_.clear();
  }

  mutable std::mutex mutex_;
  std::vector<std::string> texts_;
  suture::MessagePort messages_{*this};
};

/// Writes down what it hears: "warning 2 (4): text".
class Listener final : public suture::EventTask {
 public:
  Listener() : EventTask({}) {
    from_.on().status([this](const Message& message) { hear("status", message); });
    from_.on().warning([this](const Message& message) { hear("warning", message); });
    from_.on().error([this](const Message& message) { hear("error", message); });
  }
  ~Listener() override { stop(); }

  bool heard(const std::vector<std::string>& lines) {
    return suture::eventually([&] {
      const std::lock_guard lock(mutex_);
      return lines_ == lines;
    });
  }

 private:
  void run() override {}

  void hear(const char* kind, const Message& message) {
    const std::lock_guard lock(mutex_);
    lines_.push_back(std::string(kind) + " " + std::to_string(message.counter) + " (" +
                     std::to_string(message.code) + "): " + message.text);
  }

  std::mutex mutex_;
  std::vector<std::string> lines_;
  suture::Required<suture::Messages> from_{*this, "From"};
};

class StandardMessages : public testing::TestWithParam<Lane> {
 protected:
  void TearDown() override { manager.stop(); }

  suture::loop::ControlThread control;
  suture::GlobalManager names{control, "tcp://127.0.0.1:0"};
  suture::Manager manager{"here", names.address()};
};

TEST_P(StandardMessages, AreHeardInOrder) {
  Speaker speaker;
  Listener listener;
  manager.add("Speaker", speaker);
  manager.add("Listener", listener);
  manager.start();
  manager.connect("Listener/From", "Speaker/Messages", {.lane = GetParam()});
  manager.awaitStart();
  speaker.say("hello");
  std::vector<std::string> lines{"status 1 (0): hello", "warning 2 (4): hello",
                                 "error 3 (0): hello"};
  ASSERT_TRUE(listener.heard(lines));
  speaker.say("there");
  lines.insert(lines.end(), {"status 4 (0): there", "warning 5 (4): there", "error 6 (0): there"});
  EXPECT_TRUE(listener.heard(lines));
  manager.stop();
}

TEST_P(StandardMessages, ALateClientHearsTheLatest) {
  Speaker speaker;
  Listener listener;
  manager.add("Speaker", speaker);
  manager.add("Listener", listener);
  manager.start();
  speaker.say("first");
  speaker.say("second");
  ASSERT_TRUE(suture::eventually([&] { return speaker.silent(); }));
  manager.connect("Listener/From", "Speaker/Messages", {.lane = GetParam()});
  EXPECT_TRUE(
      listener.heard({"status 4 (0): second", "warning 5 (4): second", "error 6 (0): second"}));
  manager.stop();
}

/// Its contract has the messages among its own members.
class BrokenLamp final : public suture::EventTask, public contracts::Lamp {
 public:
  BrokenLamp() : EventTask({}) {}
  ~BrokenLamp() override { stop(); }

  void light(bool on) override {
    if (on) messages_.error("the bulb is broken", 12);
  }
  bool lit() const override { return false; }

 private:
  void run() override {}

  suture::Provided<contracts::Lamp> lamp_{*this, "Lamp", *this};
  suture::MessageSender<contracts::Lamp> messages_{lamp_};
};

struct Switch final : suture::Device {
  suture::Required<contracts::Lamp> lamp{*this, "Lamp"};
};

TEST_P(StandardMessages, ADerivedContractHasThemToo) {
  BrokenLamp lamp;
  Listener listener;
  Switch key;
  manager.add("Lamp", lamp);
  manager.add("Listener", listener);
  manager.add("Switch", key);
  manager.start();
  manager.connect("Listener/From", "Lamp/Lamp", {.lane = GetParam()});
  manager.connect("Switch/Lamp", "Lamp/Lamp", {.lane = GetParam()});
  manager.awaitStart();
  ASSERT_TRUE(key.lamp.light(true));
  EXPECT_TRUE(listener.heard({"error 1 (12): the bulb is broken"}));
  manager.stop();
}

INSTANTIATE_TEST_SUITE_P(Lanes, StandardMessages, testing::Values(Lane::Auto, Lane::Rpc),
                         [](const auto& lane) {
                           return lane.param == Lane::Auto ? "Local" : "Rpc";
                         });

/// Tells how many messages have come, and if one was a mixture of two.
struct Counter final : suture::EventTask {
  Counter() : EventTask({}) {
    from.on().warning([this](const Message& message) {
      if (message.text != std::string(200, static_cast<char>('a' + message.code))) ++mixed;
      ++heard;
    });
  }
  ~Counter() override { stop(); }
  void run() override {}

  suture::Required<suture::Messages> from{*this, "From"};
  int mixed = 0, heard = 0;
};

struct ManyVoices final : suture::Device {
  suture::MessagePort messages{*this};
};

TEST(MessagePort, ManyThreadsMayUseADevicesPort) {
  ManyVoices device;
  Counter counter;
  suture::Manager manager("here");
  manager.add("Device", device);
  manager.add("Counter", counter);
  manager.start();
  manager.connect("Counter/From", "Device/Messages");
  manager.awaitStart();
  std::vector<std::thread> threads;
  for (unsigned voice = 0; voice < 4; ++voice) {
    threads.emplace_back([&device, voice] {
      const std::string text(200, static_cast<char>('a' + voice));
      for (int i = 0; i < 50'000; ++i) device.messages.warning(text, voice);
    });
  }
  for (std::thread& thread : threads) thread.join();
  const auto& events = manager.channels().front()->events;
  EXPECT_TRUE(suture::eventually([&] { return events.delivered() > 0; }));
  manager.stop();
  EXPECT_EQ(counter.mixed, 0);
  EXPECT_GT(counter.heard, 0);
}

}  // namespace
