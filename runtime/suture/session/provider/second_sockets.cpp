#include <suture/session/provider/second_sockets.h>

#include <utility>

namespace suture {
namespace {

constexpr std::size_t kMostOnTheirWay = 16;

}  // namespace

tl::expected<SecondSockets::Expected, std::string> SecondSockets::await(LaneServer& lane) {
  // A client gives up a socket that does not come, and asks for another.
  if (onTheirWay_.size() == kMostOnTheirWay) onTheirWay_.erase(onTheirWay_.begin());
  if (auto why = places_.whyNone(caller_->identity)) return tl::unexpected(*std::move(why));
  const std::uint32_t number = ++latest_;
  auto awaiting = awaited_.await(
      caller_->identity, [this, &lane, number,
                          place = places_.take(caller_->identity)](net::ByteStream bytes) mutable {
        onTheirWay_.erase(number);
        bytes.attach(std::move(place));
        lane.opened({number, kj::mv(bytes), caller_->share()});
      });
  const Expected expected{number, awaiting->token()};
  onTheirWay_.emplace(number, kj::mv(awaiting));
  return expected;
}

}  // namespace suture
