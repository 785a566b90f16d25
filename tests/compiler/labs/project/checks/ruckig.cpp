// These are Ruckig's instances for seven joints: infinite limits, optionals, enums inside of a
// class.

#include "values/ruckig.h"
#include "connected.h"
#include "labs/ruckig.capnp.h"
#include "labs/ruckig.suture.h"

namespace lab {

void toWire(const Input7Slot&, wire::Input7::Builder);
suture::Errc fromWire(wire::Input7::Reader, Input7Slot&, suture::Duration);
bool isValid(const Input7Slot&, suture::FieldPath* = nullptr);
void toWire(const Output7Slot&, wire::Output7::Builder);
suture::Errc fromWire(wire::Output7::Reader, Output7Slot&, suture::Duration);
bool isValid(const Output7Slot&, suture::FieldPath* = nullptr);
void toWire(const ruckigProfileSlot&, wire::Profile::Builder);
suture::Errc fromWire(wire::Profile::Reader, ruckigProfileSlot&, suture::Duration);
bool isValid(const ruckigProfileSlot&, suture::FieldPath* = nullptr);

}  // namespace lab

namespace invented {

class RuckigProvider final : public suture::EventTask, public lab::Planner {
 public:
  ruckig::Result plan(const lab::Input7& input) override {
    output_.new_position = input.target_position;
    output_.calculation_duration = input.max_jerk[0];
    profile_.brake.t = {input.target_position[0], 1};
    require(port_.emit().ended(profile_, ruckig::ErrorZeroLimits).has_value(), "ended",
            "is not emitted");
    return ruckig::Finished;
  }
  const lab::Output7& output() const override { return output_; }
  void run() override {}

 private:
  lab::Output7 output_{};
  Profile profile_{};
  suture::Provided<lab::Planner> port_{*this, "Port", *this};
};

void connectRuckig(Random& random) {
  int events = 0;
  Profile heard;
  Connected<lab::Planner, RuckigProvider> planner([&](auto& port) {
    port.on().ended([&](const Profile& profile, ruckig::Result result) {
      heard = profile;
      events += result == ruckig::ErrorZeroLimits ? 1 : 0;
    });
  });
  for (int round = 1; round <= 20; ++round) {
    lab::Input7 input;
    fill(input, random);
    input.max_jerk[0] = 1;  // what the provider publishes of it has no range
    const auto result = planner.port().plan.start(input).within(10s);
    require(result && *result == ruckig::Finished, "plan", "answers something else");
    planner.until([&] { return events == round; }, "ended");
    require(equal(heard.brake.t[0], input.target_position[0], Tag()), "ended", "is another one");
    const auto output = planner.port().output.fresh().within(10s);
    require(output && same(output->new_position, input.target_position), "output", "differs");
  }
}

void checkRuckig(Random& random) {
  checkType<lab::Input7, lab::Input7Slot, lab::wire::Input7>("Input7", random);
  checkType<lab::Output7, lab::Output7Slot, lab::wire::Output7>("Output7", random);
  checkType<Profile, lab::ruckigProfileSlot, lab::wire::Profile>("Profile", random);

  // Ruckig's constructor makes infinite limits; the other members keep whatever was there.
  lab::Input7 input;
  input.max_velocity.fill(kInfinity);
  for (auto* position : {&input.current_position, &input.target_position}) position->fill(0);
  require(input.max_jerk[6] == kInfinity, "Input7", "ruckig does not begin with infinite limits");
  checkRefused<lab::Input7Slot>(input, "");
  input.max_jerk[6] = -kInfinity;
  checkRefused<lab::Input7Slot>(input, "max_jerk[6]");
  input.max_jerk[6] = kNaN;
  checkRefused<lab::Input7Slot>(input, "max_jerk[6]");
  input.max_jerk[6] = 1;
  input.min_velocity.emplace().fill(0);
  input.min_velocity->at(2) = kNaN;
  checkRefused<lab::Input7Slot>(input, "min_velocity[2]");
  connectRuckig(random);
}

}  // namespace invented
