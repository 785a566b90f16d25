// These are MAVLink's packed structs. No reference to their members is taken, for few lie where
// they should.

#include "values/mavlink.h"
#include "connected.h"
#include "labs/mavlink.capnp.h"
#include "labs/mavlink.suture.h"

namespace lab {

void toWire(const mavlink_attitude_tSlot&, wire::MavlinkAttitudeT::Builder);
suture::Errc fromWire(wire::MavlinkAttitudeT::Reader, mavlink_attitude_tSlot&, suture::Duration);
bool isValid(const mavlink_attitude_tSlot&, suture::FieldPath* = nullptr);
void toWire(const mavlink_heartbeat_tSlot&, wire::MavlinkHeartbeatT::Builder);
suture::Errc fromWire(wire::MavlinkHeartbeatT::Reader, mavlink_heartbeat_tSlot&, suture::Duration);
bool isValid(const mavlink_heartbeat_tSlot&, suture::FieldPath* = nullptr);
void toWire(const mavlink_battery_status_tSlot&, wire::MavlinkBatteryStatusT::Builder);
suture::Errc fromWire(wire::MavlinkBatteryStatusT::Reader, mavlink_battery_status_tSlot&,
                      suture::Duration);
bool isValid(const mavlink_battery_status_tSlot&, suture::FieldPath* = nullptr);
void toWire(const mavlink_odometry_tSlot&, wire::MavlinkOdometryT::Builder);
suture::Errc fromWire(wire::MavlinkOdometryT::Reader, mavlink_odometry_tSlot&, suture::Duration);
bool isValid(const mavlink_odometry_tSlot&, suture::FieldPath* = nullptr);
void toWire(const mavlink_statustext_tSlot&, wire::MavlinkStatustextT::Builder);
suture::Errc fromWire(wire::MavlinkStatustextT::Reader, mavlink_statustext_tSlot&,
                      suture::Duration);
bool isValid(const mavlink_statustext_tSlot&, suture::FieldPath* = nullptr);
void toWire(const mavlink_status_tSlot&, wire::MavlinkStatusT::Builder);
suture::Errc fromWire(wire::MavlinkStatusT::Reader, mavlink_status_tSlot&, suture::Duration);
bool isValid(const mavlink_status_tSlot&, suture::FieldPath* = nullptr);
void toWire(const mavlink_message_tSlot&, wire::MavlinkMessageT::Builder);
suture::Errc fromWire(wire::MavlinkMessageT::Reader, mavlink_message_tSlot&, suture::Duration);
bool isValid(const mavlink_message_tSlot&, suture::FieldPath* = nullptr);

}  // namespace lab

namespace invented {

class MavlinkProvider final : public suture::EventTask, public lab::Autopilot {
 public:
  void attitude(const mavlink_attitude_t& attitude) override {
    odometry_.time_usec = attitude.time_boot_ms;
    odometry_.q[3] = attitude.yawspeed;
    require(port_.emit().heartbeat({1, 2}, heartbeat_).has_value(), "heartbeat", "is not emitted");
  }
  void setMode(MAV_MODE_FLAG mode) override {
    mavlink_statustext_t said{};
    said.id = static_cast<std::uint16_t>(mode);
    std::strcpy(said.text, "mode");
    require(port_.emit().text(said, MAV_SEVERITY_DEBUG).has_value(), "text", "is not emitted");
  }
  const mavlink_odometry_t& odometry() const override { return odometry_; }
  const mavlink_battery_status_t& battery() const override { return battery_; }
  const mavlink_status_t& status() const override { return status_; }
  void run() override {}

 private:
  mavlink_odometry_t odometry_{};
  mavlink_battery_status_t battery_{};
  mavlink_status_t status_{};
  mavlink_heartbeat_t heartbeat_{};
  suture::Provided<lab::Autopilot> port_{*this, "Port", *this};
};

void connectMavlink(Random& random) {
  int beats = 0;
  mavlink_statustext_t heard{};
  Connected<lab::Autopilot, MavlinkProvider> autopilot([&](auto& port) {
    port.on().heartbeat([&](const mavlink_system_t& from, const mavlink_heartbeat_t&) {
      beats += from.compid == 2 ? 1 : 0;
    });
    port.on().text([&](const mavlink_statustext_t& text, MAV_SEVERITY severity) {
      if (severity == MAV_SEVERITY_DEBUG) heard = text;
    });
  });
  mavlink_attitude_t attitude;
  fill(attitude, random);
  require(autopilot.port().attitude(attitude).has_value(), "attitude", "is not sent");
  autopilot.until([&] { return beats == 1; }, "heartbeat");
  const auto odometry = autopilot.port().odometry.fresh().within(10s);
  require(odometry && odometry->time_usec == attitude.time_boot_ms, "odometry", "is another one");
  require(autopilot.port().setMode(MAV_MODE_FLAG_SAFETY_ARMED).has_value(), "mode", "is not sent");
  autopilot.until([&] { return heard.id == MAV_MODE_FLAG_SAFETY_ARMED; }, "text");
  require(std::strcmp(heard.text, "mode") == 0, "text", "is another one");
}

void checkMavlink(Random& random) {
  using namespace lab;
  checkType<mavlink_attitude_t, mavlink_attitude_tSlot, lab::wire::MavlinkAttitudeT>("attitude",
                                                                                     random);
  checkType<mavlink_heartbeat_t, mavlink_heartbeat_tSlot, lab::wire::MavlinkHeartbeatT>("heartbeat",
                                                                                        random);
  checkType<mavlink_battery_status_t, mavlink_battery_status_tSlot,
            lab::wire::MavlinkBatteryStatusT>("battery_status", random);
  checkType<mavlink_odometry_t, mavlink_odometry_tSlot, lab::wire::MavlinkOdometryT>("odometry",
                                                                                     random);
  checkType<mavlink_status_t, mavlink_status_tSlot, lab::wire::MavlinkStatusT>("status", random);

  checkType<mavlink_statustext_t, mavlink_statustext_tSlot, lab::wire::MavlinkStatustextT>(
      "statustext", random);
  checkType<mavlink_message_t, mavlink_message_tSlot, lab::wire::MavlinkMessageT>("message",
                                                                                  random);

  mavlink_odometry_t odometry{};
  checkRefused<mavlink_odometry_tSlot>(odometry, "");
  odometry.pose_covariance[20] = std::numeric_limits<float>::quiet_NaN();
  checkRefused<mavlink_odometry_tSlot>(odometry, "pose_covariance[20]");
  connectMavlink(random);
}

}  // namespace invented
