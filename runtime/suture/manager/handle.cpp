#include <suture/manager/handle.h>

namespace suture {

void HandleBase::open(Manager& manager, RequiredBase& required, std::string_view provided,
                      const ConnectOptions& options) {
  manager.connect(*this, required, provided, options);
  manager_ = &manager;
}

void HandleBase::close() {
  if (manager_ != nullptr) manager_->disconnect(*this);
}

}  // namespace suture
