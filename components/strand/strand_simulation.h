#pragma once
// This is the task that simulates the strand between two arms' tips.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <optional>

#include "arm/arm.suture.h"
#include "registration/registration.suture.h"
#include "strand/strand.h"
#include "strand/strand_view.suture.h"

namespace robots {

struct SUTURE_TYPE() StrandParameters {
  suture::Duration period = std::chrono::milliseconds(1);
  SUTURE_FIELD(unit("m"), range(0.02, 1)) double length = 0.11;
  /// Strand on strand has this coefficient of friction.
  SUTURE_FIELD(range(0, 1)) double friction = 0.15;
  /// The strand winds about itself by this angle in the knot.
  SUTURE_FIELD(unit("rad"), range(0, 100)) double wrap = 9.42;
};

/// Simulates a strand of which each arm holds one end in its tip. It begins once both arms and the
/// registration answer and the tips are a millimetre apart, with the strand straight between them;
/// they must not be farther apart than its length, or it stretches.
class SUTURE_COMPONENT() StrandSimulation final : public suture::PeriodicTask, public StrandView {
 public:
  explicit StrandSimulation(const StrandParameters& parameters);

  const StrandState& strand() const override { return state_; }

  void run() override;

 private:
  StrandModel model_;
  suture::Required<Arm> left_{*this, "Left"};
  suture::Required<Arm> right_{*this, "Right"};
  suture::Required<Registration> registration_{*this, "Registration"};
  suture::Provided<StrandView> view_{*this, "Strand", *this};
  std::optional<Strand> strand_;
  StrandState state_;
};

}  // namespace robots
