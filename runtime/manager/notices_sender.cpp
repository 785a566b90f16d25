#include <suture/manager/notices_sender.h>

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

void NoticesSender::replays(std::uint16_t event, Time stamp) {
  auto request = client_.replayedRequest();
  request.setEvent(event);
  request.setStamp(toNanoseconds(stamp));
  send(kj::mv(request));
}

}  // namespace suture
