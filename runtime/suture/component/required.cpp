#include <suture/component/channel/channel.h>
#include <suture/component/contract/unbounded.h>
#include <suture/component/required.h>
#include <suture/rt/queue/event_queue.h>

#include <utility>

namespace suture {

RequiredBase::RequiredBase(Component& owner, std::string_view name, const InterfaceInfo& info)
    : RequiredParts(owner, name, info) {
  refuseUnbounded(info, owner.ownsThread());
  owner.required_.push_back(this);
}

RequiredBase::~RequiredBase() { attachment.close(); }

FieldPath RequiredBase::lastInvalid() const {
  return channel() == nullptr ? FieldPath() : channel()->lastInvalid.read();
}

void RequiredBase::attach(std::shared_ptr<Channel> channel) {
  expectConnection();
  {
    const std::lock_guard lock(attachedMutex_);
    attached_ = channel;
  }
  attachment.attach(std::move(channel));
}

std::shared_ptr<Channel> RequiredBase::attached() const {
  const std::lock_guard lock(attachedMutex_);
  return attached_.lock();
}

void RequiredBase::handleEvents() {
  const bool atItsEnd = owner().ending();
  subscriptions.handleQueued();
  if (!atItsEnd && owner().ending()) return;
  calls.markSeen();
  subscriptions.markSeen();
  calls.finishFollowed();
}

bool RequiredBase::pending() const {
  return rewired() || calls.followedMayBeDone() || subscriptions.pending();
}

// To look for answers takes the flag for which the provider would ring again, so events are looked
// for after that.
bool RequiredBase::unseen() {
  const bool answered = calls.unseen();
  return answered || subscriptions.unseen() || pending();
}

Result<void> RequiredBase::handle(std::uint16_t event,
                                  std::function<void(const std::byte*, Time)> handler) {
  return resultOf<void>(
      subscriptions.subscribe(event, [handler = std::move(handler)](const std::byte* payload) {
        handler(payload, rt::EventRecord::of(payload).stamp);
      }));
}

void RequiredBase::watch(ProvidedBase& own) {
  std::erase(owner().required_, this);
  attachment.watch(own);
}

}  // namespace suture
