#include <suture/base/virtual_time.h>
#include <suture/component/channel/channel.h>
#include <suture/component/component.h>
#include <suture/component/required/command_sender.h>
#include <suture/component/sleep.h>
#include <suture/rt/counter.h>

namespace suture {

ProvidedBase* CommandSender::callee(std::uint16_t command) const {
  const Channel::Ends& ends = attachment_.channel()->ends;
  return infoOf(command).inCallersThread ? ends.here : ends.device;
}

Errc CommandSender::claim(std::uint16_t command, std::uint32_t call, std::byte*& arguments) {
  if (lending_) return Errc::OnLoan;
  rt::Mailbox& mailbox = attachment_.channel()->commands;
  const Result<std::byte*> claimed = mailbox.claim(command, now(), call);
  if (!claimed) return claimed.error();
  if (VirtualTime* const time = virtualTime(); time != nullptr) {
    time->note(VirtualTime::Kind::Send, attachment_.name().c_str(), infoOf(command).name,
               mailbox.nextSequence());
  }
  arguments = *claimed;
  return Errc{};
}

Errc CommandSender::judge(std::uint16_t command, const std::byte* arguments, bool fits) {
  Channel& channel = *attachment_.channel();
  rt::MailboxCounters& counters = channel.commands.counters;
  if (!fits) {
    counters.tooLarge.fetch_add(1, std::memory_order_relaxed);
    return Errc::TooLarge;
  }
  if (channel.admits(infoOf(command), arguments)) return Errc{};
  counters.invalid.fetch_add(1, std::memory_order_relaxed);
  return Errc::Invalid;
}

Errc CommandSender::commit(std::uint16_t command, const std::byte* arguments, bool fits) {
  Channel& channel = *attachment_.channel();
  if (const Errc error = judge(command, arguments, fits); error != Errc{}) {
    channel.commands.abandon();
    return error;
  }
  channel.countSent(channel.commands.commit());
  attachment_.owner().ringLater(*channel.ends.provider);
  return Errc{};
}

CommandSender::Loan::~Loan() {
  sender_.lending_ = false;
  if (claimed_) channel_->commands.abandon();
}

// A component that waits in its own code may get another connection meanwhile.
Errc CommandSender::Loan::broken(std::uint16_t command) const {
  Attachment& attachment = sender_.attachment_;
  return attachment.channel() == channel_ ? attachment.unusable(command) : Errc::Lost;
}

Errc CommandSender::Loan::commit(std::uint16_t command, const std::byte* arguments, bool fits) {
  if (const Errc error = broken(command); error != Errc{}) return error;
  claimed_ = false;
  return sender_.commit(command, arguments, fits);
}

// Counts once it has run: the command itself may have had the connection taken down.
Errc CommandSender::countHere(Errc error) {
  Channel* const channel = attachment_.channel().get();
  if (channel == nullptr) return error;
  ChannelCounts& counts = *channel->counts;
  rt::increment(channel->commands.counters.sent);
  rt::increment(error == Errc{} ? counts.executedHere : counts.failedHere);
  return error;
}

bool CommandSender::admitsResult(std::uint16_t command, const std::byte* result) const {
  return attachment_.channel()->admitsResult(infoOf(command), result);
}

std::uint32_t CommandSender::room(std::uint16_t command) {
  if (attachment_.unusable(command) != Errc{}) return 0;
  if (callee(command) != nullptr) return rt::Mailbox::kUnlimited;
  return attachment_.channel()->commands.room(command);
}

// A task takes over another connection only between its cycles, so it has no room until then.
Errc CommandSender::whyNotAwaited(std::uint16_t command) const {
  const Errc error = attachment_.unusable(command);
  if (error != Errc{}) return error;
  return attachment_.rewired() || attachment_.owner().ending() ? Errc::Lost : Errc{};
}

Result<std::uint32_t> CommandSender::roomWithin(std::uint16_t command, Duration limit) {
  std::uint32_t found = 0;
  Errc error{};
  const auto over = [&] {
    found = room(command);
    if (found == 0) error = whyNotAwaited(command);
    return found != 0 || error != Errc{};
  };
  if (!over()) sleepUntil(attachment_.owner(), fromNow(limit), over);
  if (found != 0) return found;
  return tl::unexpected(error != Errc{} ? error : Errc::Timeout);
}

Duration CommandSender::deadlineOf(std::uint16_t command) const {
  const ConnectionWatch* const watch = attachment_.channel()->terms.watch.get();
  const bool agreed = watch != nullptr && watch->contract.deadline > Duration{0};
  return agreed ? watch->contract.deadline : infoOf(command).deadline;
}

}  // namespace suture
