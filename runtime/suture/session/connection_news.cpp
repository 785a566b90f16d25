#include <suture/session/connection_news.h>

#include <utility>

namespace suture {

void ConnectionNews::made(const std::string& required, std::shared_ptr<Channel> channel) {
  const std::lock_guard lock(mutex_);
  whyNotBack_.erase(channel->name());
  connected_[required] = std::move(channel);
}

void ConnectionNews::lost(const std::string& channel, std::string why) {
  const std::lock_guard lock(mutex_);
  whyLost_[channel] = std::move(why);
  whyNotBack_.erase(channel);
}

void ConnectionNews::notBack(const std::string& channel, std::string why) {
  const std::lock_guard lock(mutex_);
  whyNotBack_[channel] = std::move(why);
}

void ConnectionNews::forget(const std::string& required) {
  const std::lock_guard lock(mutex_);
  const auto found = connected_.find(required);
  if (found == connected_.end()) return;
  whyLost_.erase(found->second->name());
  whyNotBack_.erase(found->second->name());
  connected_.erase(found);
}

std::map<std::string, std::shared_ptr<Channel>> ConnectionNews::connected() const {
  const std::lock_guard lock(mutex_);
  return connected_;
}

std::shared_ptr<Channel> ConnectionNews::connected(const std::string& required) const {
  const std::lock_guard lock(mutex_);
  const auto found = connected_.find(required);
  return found == connected_.end() ? nullptr : found->second;
}

std::map<std::string, std::string> ConnectionNews::whyLost() const {
  const std::lock_guard lock(mutex_);
  return whyLost_;
}

std::map<std::string, std::string> ConnectionNews::whyNotBack() const {
  const std::lock_guard lock(mutex_);
  return whyNotBack_;
}

}  // namespace suture
