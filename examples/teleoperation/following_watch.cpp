#include "following_watch.h"

namespace demo {

FollowingWatch::FollowingWatch(const Following& following)
    : following_(following),
      master_(following.masterRecording),
      teleop_(following.teleopRecording),
      slave_(following.slaveRecording),
      judge_(following.timeConstant) {}

robots::ErrorSummary FollowingWatch::recent() {
  judge_.addSlave(slave_.next().arm);
  judge_.addMaster(master_.next().arm);
  judge_.addFollowed(teleop_.next().followed);
  judge_.advance();
  return judge_.recentPosition();
}

robots::Judgement FollowingWatch::finish() {
  judge_.addSlave(slave_.rest().arm);
  judge_.addMaster(master_.rest().arm);
  judge_.addFollowed(teleop_.rest().followed);
  return judge_.finish();
}

std::vector<FollowingWatch> watchAll(const std::vector<Following>& followings) {
  std::vector<FollowingWatch> watches;
  for (const Following& following : followings) watches.emplace_back(following);
  return watches;
}

}  // namespace demo
