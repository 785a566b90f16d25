#include <suture/base/plain.h>
#include <suture/codec/tallies.h>
#include <suture/codec/text.h>
#include <suture/session/client/notices_receiver.h>

#include <utility>

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

void ProviderNews::giveUp(std::string why) {
  givenUp_ = std::move(why);
  KJ_IF_MAYBE (end, end_) (*end)->tellBroken(givenUp_);
}

void ProviderNews::passOnTo(kj::Own<ClientEnd> end) {
  end->tell(status_);
  if (!givenUp_.empty()) end->tellBroken(givenUp_);
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
  ledger_->tell(codec::fromWire(context.getParams().getEarlier()));
  return kj::READY_NOW;
}

kj::Promise<void> NoticesReceiver::lapsed(LapsedContext) {
  news_->giveUp(kLapsed);
  return kj::READY_NOW;
}

// The end of the socket may have been noticed already, which says nothing of the reason.
kj::Promise<void> NoticesReceiver::refused(RefusedContext context) {
  std::string why = "refused: " + plain(codec::stringOf(context.getParams().getWhy()));
  lost_(why);
  news_->giveUp(std::move(why));
  return kj::READY_NOW;
}

kj::Promise<void> NoticesReceiver::closed(ClosedContext) {
  lost_("ended: its component has been stopped, or a later connection of this interface stands");
  news_->close();
  return kj::READY_NOW;
}

}  // namespace suture
