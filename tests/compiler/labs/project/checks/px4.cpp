// These are PX4's topics, whose padding is carried or not, as the header says.

#include "values/px4.h"
#include "connected.h"
#include "labs/px4.capnp.h"
#include "labs/px4.suture.h"

namespace lab {

void toWire(const vehicle_attitude_sSlot&, wire::VehicleAttitudeS::Builder);
suture::Errc fromWire(wire::VehicleAttitudeS::Reader, vehicle_attitude_sSlot&, suture::Duration);
bool isValid(const vehicle_attitude_sSlot&, suture::FieldPath* = nullptr);
void toWire(const px4msgVehicleStatusSlot&, wire::VehicleStatus::Builder);
suture::Errc fromWire(wire::VehicleStatus::Reader, px4msgVehicleStatusSlot&, suture::Duration);
bool isValid(const px4msgVehicleStatusSlot&, suture::FieldPath* = nullptr);
void toWire(const esc_status_sSlot&, wire::EscStatusS::Builder);
suture::Errc fromWire(wire::EscStatusS::Reader, esc_status_sSlot&, suture::Duration);
bool isValid(const esc_status_sSlot&, suture::FieldPath* = nullptr);
void toWire(const debug_key_value_sSlot&, wire::DebugKeyValueS::Builder);
suture::Errc fromWire(wire::DebugKeyValueS::Reader, debug_key_value_sSlot&, suture::Duration);
bool isValid(const debug_key_value_sSlot&, suture::FieldPath* = nullptr);

}  // namespace lab

namespace invented {

class Px4Provider final : public suture::EventTask, public lab::Vehicle {
 public:
  void turn(const vehicle_attitude_s& goal) override {
    attitude_ = goal;
    require(port_.emit().debugged({7, 1, "goal", {}}).has_value(), "debugged", "is not emitted");
  }
  const px4::msg::VehicleStatus& status() const override { return status_; }
  const px4::msg::VehicleAttitude& attitude() const override { return attitude_; }
  const esc_status_s& escs() const override { return escs_; }
  void run() override {}

 private:
  vehicle_status_s status_{};
  vehicle_attitude_s attitude_{};
  esc_status_s escs_{};
  suture::Provided<lab::Vehicle> port_{*this, "Port", *this};
};

void connectPx4(Random& random) {
  int events = 0;
  Connected<lab::Vehicle, Px4Provider> vehicle([&](auto& port) {
    port.on().debugged([&](const debug_key_value_s& debug) {
      events += std::strcmp(debug.key, "goal") == 0 ? 1 : 0;
    });
  });
  vehicle_attitude_s goal{};
  fill(goal, random);
  require(vehicle.port().turn(goal).has_value(), "turn", "is not sent");
  vehicle.until([&] { return events == 1; }, "debugged");
  const auto attitude = vehicle.port().attitude.fresh().within(10s);
  require(attitude && same(*attitude, goal), "attitude", "is another one");
}

void checkPx4(Random& random) {
  checkType<vehicle_attitude_s, lab::vehicle_attitude_sSlot, lab::wire::VehicleAttitudeS>(
      "attitude", random);
  checkType<vehicle_status_s, lab::px4msgVehicleStatusSlot, lab::wire::VehicleStatus>("status",
                                                                                      random);
  checkType<esc_status_s, lab::esc_status_sSlot, lab::wire::EscStatusS>("escs", random);
  checkType<debug_key_value_s, lab::debug_key_value_sSlot, lab::wire::DebugKeyValueS>("debug",
                                                                                      random);

  esc_status_s status{};
  status.esc[7].esc_current = std::numeric_limits<float>::infinity();
  checkRefused<lab::esc_status_sSlot>(status, "esc[7].esc_current");
  connectPx4(random);
}

}  // namespace invented
