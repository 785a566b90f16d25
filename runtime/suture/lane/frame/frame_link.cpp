#include <suture/lane/frame/frame_link.h>

#include <algorithm>
#include <utility>

namespace suture::frame {
namespace {

bool isBefore(const std::shared_ptr<Connection>& connection, std::uint32_t number) {
  return connection->number() < number;
}

}  // namespace

void FrameLink::join(std::shared_ptr<Connection> connection) {
  const std::lock_guard lock(mutex_);
  if (broken_) return connection->breakOff(socket_.why());
  joined_.push_back(std::move(connection));
  anyJoined_ = true;
}

void FrameLink::takeJoined() {
  if (!anyJoined_) return;
  const std::lock_guard lock(mutex_);
  for (auto& one : joined_) {
    if (find(one->number()) != nullptr) {
      one->breakOff("another connection has its number");
      continue;
    }
    one->use(socket_, surplus_);
    const auto place =
        std::lower_bound(connections_.begin(), connections_.end(), one->number(), isBefore);
    connections_.insert(place, std::move(one));
  }
  joined_.clear();
  anyJoined_ = false;
}

Connection* FrameLink::find(std::uint32_t number) const {
  const auto place = std::lower_bound(connections_.begin(), connections_.end(), number, isBefore);
  return place != connections_.end() && (*place)->number() == number ? place->get() : nullptr;
}

void FrameLink::turn() {
  receive();
  // What did not fit goes at the next turn, or when the socket tells that it takes more.
  unsent_ = send();
  socket_.flush();
  if (socket_.broken()) breakAll();
  std::erase_if(connections_, [this](const auto& one) {
    const bool over = one->over();  // asked once, because any thread may end it in between
    if (over) surplus_.giveBack(one->surplus());
    return over;
  });
}

bool FrameLink::gives() {
  unsent_ = send();
  return socket_.isFull();
}

// A connection joins before its peer sends, so it is here at the latest after a receipt. The number
// of fills is bounded, so that a peer that sends without end leaves the others their turns.
void FrameLink::receive() {
  constexpr int kMostFills = 8;
  int fills = 0;
  bool any = false;
  do {
    takeJoined();
    while (const Header* const header = socket_.next()) {
      if (!take(*header)) {
        const std::string& why = surplus_.whyNot();
        return socket_.refuse(why.empty() ? "a frame makes no sense" : why);
      }
      any = true;
    }
  } while (++fills < kMostFills && socket_.receive());
  if (!any) return;
  for (const auto& one : connections_) one->taken();
}

// Drops what comes for a connection that has ended.
bool FrameLink::take(const Header& header) {
  Connection* const connection = find(header.connection);
  return connection == nullptr || connection->over() ||
         connection->arrived(header, socket_.payload());
}

// Begins with another connection at each turn, so that none can always take all the room.
bool FrameLink::send() {
  const std::size_t count = connections_.size();
  if (count == 0) return false;
  if (!socket_.hasRoom()) return true;
  bool more = false;
  first_ = (first_ + 1) % count;
  for (std::size_t i = 0; i < count; ++i) {
    Connection& connection = *connections_[(first_ + i) % count];
    if (!connection.over() && connection.send()) more = true;
  }
  return more;
}

// A connection that joins later finds the link broken.
void FrameLink::breakAll() {
  const std::lock_guard lock(mutex_);
  broken_.store(true, std::memory_order_release);
  for (const auto* all : {&joined_, &connections_}) {
    for (const auto& one : *all) one->breakOff(socket_.why(), socket_.refusal());
  }
}

bool FrameLink::endIfEmpty() {
  if (!connections_.empty()) return false;
  const std::lock_guard lock(mutex_);
  if (!joined_.empty()) return false;
  socket_.breakOff("all of its connections have ended");
  broken_.store(true, std::memory_order_release);
  return true;
}

}  // namespace suture::frame
