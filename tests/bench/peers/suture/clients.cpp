#include "suture/clients.h"

#include <suture/base/errors.h>

#include <cstdint>

#include "harness/fail.h"

namespace peers {
namespace {

using namespace std::chrono_literals;

constexpr auto kPatience = 5s;

template <class Outcome>
void require(const Outcome& outcome, const char* what) {
  if (!outcome) fail(std::string(what) + ": " + toString(outcome.error()));
}

class ServerClient final : public Client {
 public:
  ServerClient(Requester& requester, Back back) : requester_(requester), back_(back) {}

  void echo(const Pose& sent, Pose& back) override {
    if (back_ == Back::AsReturnValue) {
      auto call = requester_.echo.ping.start(sent);
      take(call.within(kPatience), back);
    } else {
      auto event = requester_.echo.on().bounced.next();
      require(requester_.echo.bounce(sent), "bounce");
      take(event.within(kPatience), back);
    }
  }

  void echo(const Blob& sent, Blob& back) override {
    roomFor(requester_.blobs.bounce);  // the event may be here before the room of the last one is
    auto event = requester_.blobs.on().bounced.next();
    require(requester_.blobs.bounce(sent), "bounce");
    take(event.within(kPatience), back);
  }

  void send(const Pose& pose) override {
    if (room_ == 0) {
      flush();
      room_ = roomFor(requester_.echo.push);
    }
    --room_;
    require(requester_.echo.push(pose), "push");
    if (++unrung_ == kBurst) flush();
  }

  void flush() override {
    unrung_ = 0;
    requester_.ringNow();
  }

 private:
  // The server is rung for every so many, and executes them while more come.
  static constexpr std::uint32_t kBurst = 256;

  template <class Answer, class Value>
  static void take(const Answer& answer, Value& back) {
    require(answer, "an answer");
    back = *answer;
  }

  static std::uint32_t roomFor(suture::QueuedCommand& command) {
    const auto room = command.roomWithin(kPatience);
    require(room, "room for a command");
    return *room;
  }

  Requester& requester_;
  const Back back_;
  std::uint32_t room_ = 0, unrung_ = 0;
};

class Publisher final : public Client {
 public:
  explicit Publisher(Requester& requester) : requester_(requester) {}

  void echo(const Pose&, Pose&) override { fail("a publisher has no answers"); }
  void echo(const Blob&, Blob&) override { fail("a publisher has no answers"); }
  void send(const Pose& pose) override {
    require(requester_.feed.emit().pose(pose), "emit");
    requester_.ringNow();
  }

 private:
  Requester& requester_;
};

}  // namespace

std::unique_ptr<Client> clientOfServer(Requester& requester, Back back) {
  return std::make_unique<ServerClient>(requester, back);
}

std::unique_ptr<Client> publisher(Requester& requester) {
  return std::make_unique<Publisher>(requester);
}

}  // namespace peers
