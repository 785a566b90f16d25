#pragma once
// This is a required interface for a thread that is no task's, such as that of a GUI or a logger.

#include <suture/component/device.h>
#include <suture/component/required.h>
#include <suture/manager/manager.h>

#include <string_view>

namespace suture {

/// Holds the part of a Handle that does not depend on the contract.
class HandleBase {
 public:
  HandleBase(const HandleBase&) = delete;
  HandleBase& operator=(const HandleBase&) = delete;

  /// Runs the handlers of the events that have arrived, in the calling thread. Answers
  /// Errc::WrongThread if that is not the handle's, and Errc::CannotWait in such a handler.
  Result<void> processEvents() { return device_.processEvents(); }
  /// Sleeps until something arrives or until `deadline`, and does the same. Returns true if
  /// something arrived, and false at once in another thread or in such a handler.
  bool waitForEvents(Time deadline) { return device_.waitForEvents(deadline); }

 protected:
  /// `name` is like "Gui/Arm". Throws SetupError.
  explicit HandleBase(std::string_view name) : name_(Endpoint::parse(name)) {}
  ~HandleBase() = default;

  Device& device() { return device_; }
  const Endpoint& endpoint() const { return name_; }
  void open(Manager& manager, RequiredBase& required, std::string_view provided,
            const ConnectOptions& options);
  void close();

 private:
  friend class Manager;

  const Endpoint name_;
  Manager* manager_ = nullptr;  // null once the manager is gone
  Device device_;
};

/// Belongs to the first thread that uses it; others get Errc::WrongThread. Give each thread its
/// own. It is a separate connection to a provided interface, with all that a Required offers:
/// commands, which ring the provider at once and keep their order within a handle, reads, calls,
/// events.
///   suture::Handle<Arm> arm(manager, "Gui/Arm", "PSM/Arm");    where the manager is used
///   arm.on().operating_state([&](const OperatingState& state) { ... });
///   arm.enable.start().within(20ms);                           in the GUI's thread
///   arm.processEvents();
/// Make and destroy it in the manager's thread while no other thread uses it; tasks may run then.
/// It may be destroyed after the manager.
template <class Contract>
class Handle final : public HandleBase, public Required<Contract> {
 public:
  /// Connects as Manager::connect() does, or throws a SetupError that says why not. `name` is what
  /// others see of it, "Gui/Arm"; no connection of this process may have it yet.
  Handle(Manager& manager, std::string_view name, std::string_view provided,
         const ConnectOptions& options = {})
      : HandleBase(name), Required<Contract>(device(), endpoint().interface) {
    open(manager, *this, provided, options);
  }
  ~Handle() { close(); }
};

}  // namespace suture
