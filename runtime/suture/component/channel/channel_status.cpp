#include <suture/component/channel/channel_status.h>

namespace suture {

const char* toString(ChannelStatus status) {
  switch (status) {
    case ChannelStatus::Connected: return "connected";
    case ChannelStatus::Lost: return "lost";
    case ChannelStatus::Faulted: return "faulted";
    case ChannelStatus::Closed: return "closed";
    case ChannelStatus::Suspended: return "suspended";
    case ChannelStatus::Lapsed: return "lapsed";
  }
  return "unknown";
}

bool isOver(ChannelStatus status) {
  return status == ChannelStatus::Lost || status == ChannelStatus::Closed ||
         status == ChannelStatus::Lapsed;
}

Errc errorOf(ChannelStatus status) {
  switch (status) {
    case ChannelStatus::Connected: return Errc{};
    case ChannelStatus::Lost:
    case ChannelStatus::Lapsed: return Errc::Lost;
    case ChannelStatus::Faulted: return Errc::Faulted;
    case ChannelStatus::Closed: return Errc::NotConnected;
    case ChannelStatus::Suspended: return Errc::Suspended;
  }
  return Errc::NotConnected;
}

Errc endOfCalls(ChannelStatus status) {
  switch (status) {
    case ChannelStatus::Connected:
    case ChannelStatus::Suspended: return Errc{};
    case ChannelStatus::Faulted: return Errc::Faulted;
    default: return Errc::OutcomeUnknown;
  }
}

ChannelStatus statusIn(ComponentState state) {
  switch (state) {
    case ComponentState::Suspended:
    case ComponentState::Stopped: return ChannelStatus::Suspended;
    case ComponentState::Faulted: return ChannelStatus::Faulted;
    default: return ChannelStatus::Connected;
  }
}

}  // namespace suture
