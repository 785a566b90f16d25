#pragma once
// This tells any thread what has become of the connections that a process has begun.

#include <suture/component/channel/channel.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace suture {

/// The control thread writes it, any thread but a task's may read. Connections are known by their
/// required interface ("Teleop/Slave"), and reasons by the name of the channel.
class ConnectionNews {
 public:
  void made(const std::string& required, std::shared_ptr<Channel> channel);
  void lost(const std::string& channel, std::string why);
  void notBack(const std::string& channel, std::string why);
  /// Forgets the connection, and its reasons.
  void forget(const std::string& required);

  /// Returns the client ends of what has been connected.
  std::map<std::string, std::shared_ptr<Channel>> connected() const;
  /// Returns that of one required interface; nullptr: it has none.
  std::shared_ptr<Channel> connected(const std::string& required) const;
  /// Returns the last reason, in words, why each channel that was lost is.
  std::map<std::string, std::string> whyLost() const;
  /// Returns in words why each channel that is lost cannot be made anew.
  std::map<std::string, std::string> whyNotBack() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Channel>> connected_;
  std::map<std::string, std::string> whyLost_, whyNotBack_;
};

}  // namespace suture
