#pragma once
// This hears what the components of a process say to people.

#include <suture/component/device.h>
#include <suture/standard/messages.suture.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

class Manager;

/// Belongs to the thread of the manager. It is a device that listens to the standard messages of
/// components, also of contracts that derive from them.
class MessageListener final : public Device {
 public:
  static constexpr const char* kName = "(messages)";

  /// `components` have their names already.
  explicit MessageListener(std::span<const std::unique_ptr<Component>> components);

  /// Call it after `manager` has been given this and has started.
  void connect(Manager& manager) const;
  /// Returns what has been said since the last call, a line each: "PSM/Crtk warning: out of reach
  /// (code 3)".
  std::vector<std::string> heard();

 private:
  struct Source {
    std::string provided;  ///< "PSM/Crtk"
    std::unique_ptr<Required<Messages>> messages;
  };

  void listenTo(const std::string& provided);

  std::vector<Source> sources_;
  std::vector<std::string> lines_;
};

}  // namespace suture
