#include "harness/measurements/contact.h"

#include <algorithm>

#include "harness/clock.h"
#include "harness/fail.h"

namespace peers {
namespace {

using namespace std::chrono_literals;

constexpr std::int64_t kPatience = 25 * kSecond;

bool allHave(double timestamp, const ControlBlock& control, int servers) {
  return std::all_of(control.received, control.received + servers, [&](const Received& received) {
    return received.lastTimestamp.load(std::memory_order_acquire) == timestamp;
  });
}

template <class Value>
void sendUntilBack(Client& client, Value value) {
  const std::int64_t end = now() + kPatience;
  while (!client.reaches(value)) {
    if (now() > end) fail("nothing came back within 25 s");
    ++value.timestamp;
  }
}

}  // namespace

std::uint64_t reach(const Clients& clients, const ControlBlock& control, int servers) {
  const std::int64_t end = now() + kPatience;
  Pose pose;
  for (std::uint64_t sent = 0; now() < end;) {
    fill(pose, sent++);
    for (const auto& client : clients) {
      client->send(pose);
      client->flush();
    }
    if (eventually([&] { return allHave(pose.timestamp, control, servers); }, 20ms, 200us)) {
      return sent;
    }
  }
  fail("not all servers were reached within 25 s");
}

void reachByEcho(Client& client, Pose first) { sendUntilBack(client, std::move(first)); }
void reachByEcho(Client& client, Blob first) { sendUntilBack(client, std::move(first)); }

}  // namespace peers
