#include <suture/codec/tallies.h>
#include <suture/codec/text.h>
#include <suture/session/provider/connections/notices_sender.h>

namespace suture {

void NoticesSender::told(ChannelStatus status) {
  switch (status) {
    case ChannelStatus::Connected: return send(client_.resumedRequest());
    case ChannelStatus::Suspended: return send(client_.suspendedRequest());
    case ChannelStatus::Faulted: return send(client_.faultedRequest());
    case ChannelStatus::Lapsed: return send(client_.lapsedRequest());
    case ChannelStatus::Lost:
    case ChannelStatus::Closed: return send(client_.closedRequest());
  }
}

void NoticesSender::tells(const Earlier& earlier) {
  auto request = client_.earlierRequest();
  codec::toWire(earlier, request.initEarlier());
  send(kj::mv(request));
}

void NoticesSender::refuses(const std::string& why) {
  auto request = client_.refusedRequest();
  request.setWhy(codec::textOf(why));
  send(kj::mv(request));
}

}  // namespace suture
