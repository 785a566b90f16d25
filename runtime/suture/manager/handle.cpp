#include <suture/manager/handle.h>

namespace suture {

void HandleBase::open(Manager& manager, RequiredBase& required, std::string_view provided,
                      Lane lane, Duration patience, const ConnectionDelay& delay,
                      const ConnectionContract& contract) {
  manager.connect(*this, required, provided, lane, patience, delay, contract);
  manager_ = &manager;
}

void HandleBase::close() {
  if (manager_ != nullptr) manager_->disconnect(*this);
}

}  // namespace suture
