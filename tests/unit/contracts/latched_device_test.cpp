// A device emits these latched events from several threads at once.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/standard/messages.suture.h>
#include <suture/wiring/connect.h>

#include <atomic>
#include <thread>

namespace {

using suture::Message;

struct TalkingDevice final : suture::Device, suture::Messages {
  suture::Provided<suture::Messages> port{*this, "Messages", *this};
};

struct LateListener final : suture::Device {
  LateListener() {
    from.on().status([this](const Message& message) { status = message.counter; });
    from.on().warning([this](const Message& message) { warning = message.counter; });
  }
  suture::Required<suture::Messages> from{*this, "From"};
  std::uint32_t status = 0, warning = 0;
};

TEST(LatchedEventsOfADevice, AreKeptWhateverElseIsEmittedMeanwhile) {
  TalkingDevice speaker;
  constexpr std::uint32_t kRounds = 100, kBurst = 200;
  std::atomic<std::uint32_t> round{0}, emitted{0};
  const auto emitEachRound = [&](const auto& emit) {
    for (std::uint32_t i = 1; i <= kRounds; ++i) {
      while (round < i) std::this_thread::yield();
      Message message;
      for (std::uint32_t j = 1; j <= kBurst; ++j) {
        message.counter = i * kBurst + j;
        emit(message);
      }
      ++emitted;
    }
  };
  std::thread one([&] {
    emitEachRound([&](const Message& m) { EXPECT_TRUE(speaker.port.emit().status(m)); });
  });
  std::thread two([&] {
    emitEachRound([&](const Message& m) { EXPECT_TRUE(speaker.port.emit().warning(m)); });
  });
  for (std::uint32_t i = 1; i <= kRounds; ++i) {
    round = i;
    while (emitted < 2 * i) std::this_thread::yield();
    LateListener late;
    suture::connectLocally(late.from, speaker.port, "late");
    late.processEvents();
    EXPECT_EQ(late.status, (i + 1) * kBurst);
    EXPECT_EQ(late.warning, (i + 1) * kBurst);
  }
  one.join();
  two.join();
}

}  // namespace
