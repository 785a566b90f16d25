#include <suture/session/client/notices_receiver.h>
#include <suture/wire/tallies.h>

namespace suture {
namespace {

constexpr const char* kLapsed =
    "silent: the provider has not heard of this process for longer than its \"silence\" allows";

}  // namespace

void ProviderNews::tell(ChannelStatus status) {
  status_ = status;
  KJ_IF_MAYBE (end, end_) (*end)->tell(status);
}

void ProviderNews::close() {
  closed_ = true;
  KJ_IF_MAYBE (end, end_) (*end)->close(ChannelStatus::Lost);
}

void ProviderNews::lapse() {
  lapsed_ = true;
  KJ_IF_MAYBE (end, end_) (*end)->tellBroken(kLapsed);
}

void ProviderNews::passOnTo(kj::Own<rpc::ClientEnd> end) {
  end->tell(status_);
  if (lapsed_) end->tellBroken(kLapsed);
  if (closed_) end->close(ChannelStatus::Lost);
  end_ = kj::mv(end);
}

kj::Promise<void> NoticesReceiver::faulted(FaultedContext) {
  news_->tell(ChannelStatus::Faulted);
  return kj::READY_NOW;
}

kj::Promise<void> NoticesReceiver::suspended(SuspendedContext) {
  news_->tell(ChannelStatus::Suspended);
  return kj::READY_NOW;
}

kj::Promise<void> NoticesReceiver::resumed(ResumedContext) {
  news_->tell(ChannelStatus::Connected);
  return kj::READY_NOW;
}

kj::Promise<void> NoticesReceiver::earlier(EarlierContext context) {
  ledger_->tell(fromWire(context.getParams().getEarlier()));
  return kj::READY_NOW;
}

kj::Promise<void> NoticesReceiver::lapsed(LapsedContext) {
  news_->lapse();
  return kj::READY_NOW;
}

kj::Promise<void> NoticesReceiver::closed(ClosedContext) {
  lost_("ended: its component has been stopped, or a later connection of this interface stands");
  news_->close();
  return kj::READY_NOW;
}

}  // namespace suture
