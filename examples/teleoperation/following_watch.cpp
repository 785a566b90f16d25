#include "following_watch.h"

#include <algorithm>
#include <utility>

namespace demo {

FollowingWatch::FollowingWatch(const Following& following)
    : following_(following),
      master_(following.masterRecording),
      teleop_(following.teleopRecording),
      slave_({following.slave, following.slaveRecording}),
      judge_(following.lag) {}

// The slave is read first, because a slave cycle can be judged only by a master that is known.
std::optional<robots::ErrorSummary> FollowingWatch::recent() {
  const robots::Recording slave = slave_.next(), master = master_.next(), teleop = teleop_.next();
  take(master, teleop, slave);
  judge_.advance();
  return judge_.recentPosition();
}

void FollowingWatch::readRest() {
  const robots::Recording slave = slave_.rest(), master = master_.rest(), teleop = teleop_.rest();
  take(master, teleop, slave);
}

robots::Judgement FollowingWatch::finish(suture::Time end, std::vector<robots::Span> excused) {
  const auto pressed = clutched(end);
  excused.insert(excused.end(), pressed.begin(), pressed.end());
  return judge_.finish({end, std::move(excused)});
}

void FollowingWatch::take(const robots::Recording& master, const robots::Recording& teleop,
                          const robots::Recording& slave) {
  judge_.addSlave(slave.arm);
  judge_.addMaster(master.arm);
  judge_.addFollowed(teleop.followed);
  clutch_.insert(clutch_.end(), teleop.clutch.begin(), teleop.clutch.end());
  const bool isOneFile = following_.teleopRecording == following_.masterRecording;
  lost_ = slave.lost + master.lost + (isOneFile ? 0 : teleop.lost);
}

Watches::Watches(const Plan& plan) {
  for (const Following& following : plan.followings()) followings.emplace_back(following);
  for (const RecordedSlave& slave : plan.judgedSlaves()) {
    const bool isFollowing =
        std::any_of(followings.begin(), followings.end(),
                    [&](const FollowingWatch& one) { return one.following().slave == slave.name; });
    if (!isFollowing) others.emplace_back(slave);
  }
}

std::optional<double> Watches::worstError() {
  std::optional<double> worst;
  for (FollowingWatch& watch : followings) {
    const auto recent = watch.recent();
    if (recent) worst = std::max(worst.value_or(0), recent->p99);
  }
  for (SlaveWatch& watch : others) watch.next();
  return worst;
}

}  // namespace demo
