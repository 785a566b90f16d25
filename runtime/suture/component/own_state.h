#pragma once
// This lets a provider read what it has published itself.

#include <suture/component/commands.h>
#include <suture/component/required.h>

namespace suture {

/// Belongs to the thread of a task. It reads the rows of one of the task's own provided interfaces,
/// for example to know where the arm was when the image was taken.
///   Provided<Arm> arm_{*this, "Arm", *this};
///   OwnState<Arm> past_{arm_};
///   const auto then = past_[&Required<Arm>::measured_cp].at(image.stamp);
template <class Contract>
class OwnState : private Required<Contract> {
 public:
  /// Declare it as a member behind `own`.
  explicit OwnState(Provided<Contract>& own) : Required<Contract>(own.owner(), own.name()) {
    this->watch(own);
  }

  template <auto Method, class Slot>
  ReadCommand<Method, Slot>& operator[](ReadCommand<Method, Slot> Required<Contract>::*read) {
    return this->*read;
  }
};

}  // namespace suture
