// Written by suturec from rt/scenarios/all_kinds.h. Do not edit.
//
// Required<Contract> calls a contract and Provided<Contract> serves it: both stand below
// the slots, in which arguments wait. all_kinds.suture.md has the reference.
#pragma once

#include <suture/base/slots/slots.h>
#include <suture/component/commands.h>
#include <suture/component/events.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include "rt/scenarios/all_kinds.h"
#include "robot_types/pose.suture.h"

namespace scenarios {

// --- AllKinds: the arguments of its commands ---

struct AllKindsSetScalarArguments {
  double value;
};

bool store(const double& value, AllKindsSetScalarArguments& slot);

struct AllKindsSetVectorArguments {
  std::array<double, 3> value;
};

bool store(const Eigen::Vector3d& value, AllKindsSetVectorArguments& slot);

struct AllKindsSetRecordArguments {
  robots::PosePrmSlot value;
};

bool store(const robots::PosePrm& value, AllKindsSetRecordArguments& slot);
void shiftStamps(AllKindsSetRecordArguments& slot, suture::Duration shift);

struct AllKindsSetTextArguments {
  suture::BoundedText<31> value;
};

bool store(const std::string& value, AllKindsSetTextArguments& slot);

struct AllKindsTwiceScalarArguments {
  double value;
};

bool store(const double& value, AllKindsTwiceScalarArguments& slot);

struct AllKindsTwiceVectorArguments {
  std::array<double, 3> value;
};

bool store(const Eigen::Vector3d& value, AllKindsTwiceVectorArguments& slot);

struct AllKindsTwiceRecordArguments {
  robots::PosePrmSlot value;
};

bool store(const robots::PosePrm& value, AllKindsTwiceRecordArguments& slot);
void shiftStamps(AllKindsTwiceRecordArguments& slot, suture::Duration shift);

struct AllKindsTwiceTextArguments {
  suture::BoundedText<15> value;
};

bool store(const std::string& value, AllKindsTwiceTextArguments& slot);

struct AllKindsSwapScalarArguments {
  double value;
};

bool store(const double& value, AllKindsSwapScalarArguments& slot);

struct AllKindsSwapVectorArguments {
  std::array<double, 3> value;
};

bool store(const Eigen::Vector3d& value, AllKindsSwapVectorArguments& slot);

struct AllKindsSwapRecordArguments {
  robots::PosePrmSlot value;
};

bool store(const robots::PosePrm& value, AllKindsSwapRecordArguments& slot);
void shiftStamps(AllKindsSwapRecordArguments& slot, suture::Duration shift);

struct AllKindsSwapTextArguments {
  suture::BoundedText<31> value;
};

bool store(const std::string& value, AllKindsSwapTextArguments& slot);

/// Numbers the commands of AllKinds.
struct AllKindsCommand {
  static constexpr std::uint16_t clear = 0;
  static constexpr std::uint16_t set_scalar = 1;
  static constexpr std::uint16_t set_vector = 2;
  static constexpr std::uint16_t set_record = 3;
  static constexpr std::uint16_t set_text = 4;
  static constexpr std::uint16_t scalar = 5;
  static constexpr std::uint16_t vector = 6;
  static constexpr std::uint16_t record = 7;
  static constexpr std::uint16_t text = 8;
  static constexpr std::uint16_t twice_scalar = 9;
  static constexpr std::uint16_t twice_vector = 10;
  static constexpr std::uint16_t twice_record = 11;
  static constexpr std::uint16_t twice_text = 12;
  static constexpr std::uint16_t take_scalar = 13;
  static constexpr std::uint16_t take_vector = 14;
  static constexpr std::uint16_t take_record = 15;
  static constexpr std::uint16_t take_text = 16;
  static constexpr std::uint16_t swap_scalar = 17;
  static constexpr std::uint16_t swap_vector = 18;
  static constexpr std::uint16_t swap_record = 19;
  static constexpr std::uint16_t swap_text = 20;
};

/// Numbers the events of AllKinds.
struct AllKindsEvent {
  static constexpr std::uint16_t cleared = 0;
  static constexpr std::uint16_t scalar_set = 1;
  static constexpr std::uint16_t vector_set = 2;
  static constexpr std::uint16_t record_set = 3;
  static constexpr std::uint16_t text_set = 4;
};

/// Numbers the reads of AllKinds as a row of the state has them.
struct AllKindsColumn {
  static constexpr std::uint16_t scalar = 0;
  static constexpr std::uint16_t vector = 1;
  static constexpr std::uint16_t record = 2;
  static constexpr std::uint16_t text = 3;
};

}  // namespace scenarios

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<scenarios::AllKinds>();

/// Calls scenarios::AllKinds of another component.
template <>
class Required<scenarios::AllKinds> : public RequiredBase {
  using Contract = scenarios::AllKinds;
  using Id = scenarios::AllKindsCommand;
  using EventId = scenarios::AllKindsEvent;

 public:
  Required(Component& owner, std::string_view name)
      : Required(owner, name, interfaceInfo<Contract>()) {}

  /// Forgets all values. This is a void command.
  /// Void: up to 16 wait.
  Command<&Contract::clear, NoSlot> clear{*this, Id::clear};
  /// Keeps a value and tells it. This is a write.
  /// Write: up to 16 wait.
  Command<&Contract::set_scalar, scenarios::AllKindsSetScalarArguments> set_scalar{
      *this, Id::set_scalar};
  /// Write: up to 16 wait.
  Command<&Contract::set_vector, scenarios::AllKindsSetVectorArguments> set_vector{
      *this, Id::set_vector};
  /// Write: up to 16 wait.
  Command<&Contract::set_record, scenarios::AllKindsSetRecordArguments> set_record{
      *this, Id::set_record};
  /// Write: up to 16 wait.
  Command<&Contract::set_text, scenarios::AllKindsSetTextArguments> set_text{*this, Id::set_text};
  /// Returns the value that is kept. This is a read.
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::scalar, double> scalar{*this, Id::scalar};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::vector, std::array<double, 3>> vector{*this, Id::vector};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::record, robots::PosePrmSlot> record{*this, Id::record};
  /// Read: answered at once with what the last cycle left.
  ReadCommand<&Contract::text, suture::BoundedText<31>> text{*this, Id::text};
  /// Returns twice the value that is given. This is a qualified read.
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::twice_scalar, scenarios::AllKindsTwiceScalarArguments,
                       double> twice_scalar{*this, Id::twice_scalar};
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::twice_vector, scenarios::AllKindsTwiceVectorArguments,
                       std::array<double, 3>> twice_vector{*this, Id::twice_vector};
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::twice_record, scenarios::AllKindsTwiceRecordArguments,
                       robots::PosePrmSlot> twice_record{*this, Id::twice_record};
  /// Qualified read: asked in the component's thread. `within()` waits 1 s for the answer.
  QualifiedReadCommand<&Contract::twice_text, scenarios::AllKindsTwiceTextArguments,
                       suture::BoundedText<31>> twice_text{*this, Id::twice_text};
  /// Returns the value that was kept, and forgets it. This is a void command with a return.
  /// Void with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::take_scalar, NoSlot, double> take_scalar{*this, Id::take_scalar};
  /// Void with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::take_vector, NoSlot, std::array<double, 3>> take_vector{
      *this, Id::take_vector};
  /// Void with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::take_record, NoSlot, robots::PosePrmSlot> take_record{
      *this, Id::take_record};
  /// Void with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::take_text, NoSlot, suture::BoundedText<31>> take_text{
      *this, Id::take_text};
  /// Keeps a value and returns the one before. This is a write with a return.
  /// Write with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::swap_scalar, scenarios::AllKindsSwapScalarArguments,
                   double> swap_scalar{*this, Id::swap_scalar};
  /// Write with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::swap_vector, scenarios::AllKindsSwapVectorArguments,
                   std::array<double, 3>> swap_vector{*this, Id::swap_vector};
  /// Write with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::swap_record, scenarios::AllKindsSwapRecordArguments,
                   robots::PosePrmSlot> swap_record{*this, Id::swap_record};
  /// Write with return: up to 16 wait. `within()` waits 1 s for the answer.
  ReturningCommand<&Contract::swap_text, scenarios::AllKindsSwapTextArguments,
                   suture::BoundedText<31>> swap_text{*this, Id::swap_text};

  /// Subscribes to the events of scenarios::AllKinds.
  struct Events {
    explicit Events(RequiredBase& required)
        : cleared{required, EventId::cleared},
          scalar_set{required, EventId::scalar_set},
          vector_set{required, EventId::vector_set},
          record_set{required, EventId::record_set},
          text_set{required, EventId::text_set} {}

    /// Tells that all values are forgotten. This is a void event.
    /// At a subscriber up to 16 wait.
    Subscription<void> cleared;
    /// Tells the value that has been set. This is a write event.
    /// At a subscriber up to 16 wait.
    Subscription<double, double> scalar_set;
    /// At a subscriber up to 16 wait.
    Subscription<std::array<double, 3>, Eigen::Vector3d> vector_set;
    /// At a subscriber up to 16 wait.
    Subscription<robots::PosePrmSlot, robots::PosePrm> record_set;
    /// At a subscriber up to 16 wait.
    Subscription<suture::BoundedText<31>, std::string> text_set;
  };
  Events& on() { return events_; }

 protected:
  // For contracts that derive from this one.
  Required(Component& owner, std::string_view name, const InterfaceInfo& info)
      : RequiredBase(owner, name, info) {}

 private:
  Events events_{*this};
};

/// Serves scenarios::AllKinds from a component.
template <>
class Provided<scenarios::AllKinds> : public ProvidedBase {
  using Contract = scenarios::AllKinds;
  using EventId = scenarios::AllKindsEvent;

 public:
  Provided(Component& owner, std::string_view name, Contract& implementation)
      : Provided(owner, name, interfaceInfo<Contract>(), &implementation, implementation) {}

  /// Emits the events of scenarios::AllKinds.
  struct Events {
    explicit Events(ProvidedBase& provided)
        : cleared{provided, EventId::cleared},
          scalar_set{provided, EventId::scalar_set},
          vector_set{provided, EventId::vector_set},
          record_set{provided, EventId::record_set},
          text_set{provided, EventId::text_set} {}

    /// Tells that all values are forgotten. This is a void event.
    Emitter<void> cleared;
    /// Tells the value that has been set. This is a write event.
    Emitter<double, double> scalar_set;
    Emitter<std::array<double, 3>, Eigen::Vector3d> vector_set;
    Emitter<robots::PosePrmSlot, robots::PosePrm> record_set;
    Emitter<suture::BoundedText<31>, std::string> text_set;
  };
  Events& emit() { return events_; }

 protected:
  // For contracts that derive from this one: `whole` points to their implementation.
  Provided(Component& owner, std::string_view name, const InterfaceInfo& info, void* whole,
           Contract& implementation)
      : ProvidedBase(owner, name, info, whole),
        implementation_(implementation) {}

  Errc execute(std::uint16_t command, const std::byte* arguments, std::byte* result) override;

 private:
  struct Dispatch;  // has a function for each command

  // Reused by every command, so that what they own is allocated once: by reserved().
  struct Scratch {
    double set_scalar_value{};
    Eigen::Vector3d set_vector_value{};
    robots::PosePrm set_record_value{};
    std::string set_text_value{};
    double twice_scalar_value{};
    Eigen::Vector3d twice_vector_value{};
    robots::PosePrm twice_record_value{};
    std::string twice_text_value{};
    double swap_scalar_value{};
    Eigen::Vector3d swap_vector_value{};
    robots::PosePrm swap_record_value{};
    std::string swap_text_value{};

    static Scratch reserved();
  };

  Contract& implementation_;
  Events events_{*this};
  Scratch scratch_ = Scratch::reserved();
};

}  // namespace suture
