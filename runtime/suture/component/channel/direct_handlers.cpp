#include <suture/component/channel/direct_handlers.h>
#include <suture/component/component.h>

#include <utility>

namespace suture {

/// While one exists, no handler is deleted.
class DirectHandlers::Calling {
 public:
  explicit Calling(const DirectHandlers& handlers) : handlers_(handlers) {
    handlers_.calling_.fetch_add(1, std::memory_order_seq_cst);
  }
  // This is in one order with awaitCalls(): either that sees the end of this call, or it is rung.
  ~Calling() {
    handlers_.calling_.fetch_sub(1, std::memory_order_seq_cst);
    if (handlers_.awaited_.load(std::memory_order_seq_cst)) handlers_.returned_.ring();
  }
  Calling(const Calling&) = delete;
  Calling& operator=(const Calling&) = delete;

 private:
  const DirectHandlers& handlers_;
};

DirectHandlers::~DirectHandlers() { clear(); }

void DirectHandlers::set(std::uint16_t event, Component& owner,
                         std::shared_ptr<const Handler> handler) {
  const std::uint64_t bit = std::uint64_t{1} << event;
  if (handler == nullptr) {
    events_.fetch_and(~bit, std::memory_order_relaxed);
    replace(event, nullptr);
  } else {
    replace(event, new Entry{owner, std::move(handler)});
    events_.fetch_or(bit, std::memory_order_relaxed);
  }
}

void DirectHandlers::clear() {
  events_.store(0, std::memory_order_relaxed);
  for (std::uint16_t event = 0; event < handlers_.size(); ++event) replace(event, nullptr);
}

// If no call is under way now, a later one meets the new entry, so the old ones may be deleted.
void DirectHandlers::replace(std::uint16_t event, Entry* entry) {
  Entry* const old = handlers_[event].exchange(entry, std::memory_order_seq_cst);
  if (old != nullptr) replaced_.emplace_back(old);
  if (calling_.fetch_add(0, std::memory_order_seq_cst) == 0) replaced_.clear();
}

void DirectHandlers::awaitCalls() const {
  awaited_.store(true, std::memory_order_seq_cst);
  while (calling_.load(std::memory_order_seq_cst) != 0) returned_.wait();
  awaited_.store(false, std::memory_order_relaxed);
}

bool DirectHandlers::call(std::uint16_t event, const std::byte* payload) const {
  const Calling calling(*this);
  const Entry* const entry = handlers_[event].load(std::memory_order_seq_cst);
  if (entry == nullptr || !entry->owner.mayRunHandlers()) return false;
  entry->owner.parkSoonOnThrow([&] { (*entry->handler)(payload); });
  return true;
}

}  // namespace suture
