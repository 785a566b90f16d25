#include <suture/component/provided.h>
#include <suture/deploy/message_listener.h>
#include <suture/manager/manager.h>

#include <utility>

namespace suture {
namespace {

// Compares hashes, since a shared library has its own tables.
bool areMessages(const InterfaceInfo& info) {
  const std::string_view messages = interfaceInfo<Messages>().hash;
  for (const InterfaceInfo* one = &info;; one = &one->base()) {
    if (messages == one->hash) return true;
    if (one->base == nullptr) return false;
  }
}

}  // namespace

MessageListener::MessageListener(std::span<const std::unique_ptr<Component>> components) {
  for (const auto& component : components) {
    for (const ProvidedBase* provided : component->provided()) {
      if (areMessages(provided->info())) listenTo(component->name() + "/" + provided->name());
    }
  }
}

void MessageListener::listenTo(const std::string& provided) {
  auto messages = std::make_unique<Required<Messages>>(*this, std::to_string(sources_.size() + 1));
  const auto keep = [this, provided](const char* kind) {
    return [this, provided, kind](const Message& message) {
      lines_.push_back(provided + " " + kind + ": " + message.text +
                       (message.code == 0 ? "" : " (code " + std::to_string(message.code) + ")"));
    };
  };
  messages->on().status(keep("status"));
  messages->on().warning(keep("warning"));
  messages->on().error(keep("error"));
  sources_.push_back({provided, std::move(messages)});
}

void MessageListener::connect(Manager& manager) const {
  for (const Source& source : sources_) {
    manager.connect(name() + "/" + source.messages->name(), source.provided);
  }
}

std::vector<std::string> MessageListener::heard() {
  processEvents();
  return std::exchange(lines_, {});
}

}  // namespace suture
