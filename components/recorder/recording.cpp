#include "recorder/recording.h"

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <ostream>

#include "recorder/json_stamp.h"

namespace robots {
namespace {

using Json = nlohmann::json;

Json toJson(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  const Eigen::Vector3d p = pose.translation();
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
}

Eigen::Isometry3d toPose(const Json& json) {
  const auto v = json.get<std::array<double, 7>>();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  pose.linear() = Eigen::Quaterniond(v[3], v[4], v[5], v[6]).normalized().toRotationMatrix();
  return pose;
}

Json toJson(const ArmRow& row) {
  return {{"stamp", suture::toNanoseconds(row.stamp)},
          {"measured", toJson(row.measured)},
          {"goal_stamp", suture::toNanoseconds(row.goal_stamp)},
          {"setpoint", toJson(row.setpoint)},
          {"enabled", row.enabled}};
}

Json toJson(const FollowAnchors& anchors) {
  return {{"followed", anchors.entry},
          {"master_stamp", suture::toNanoseconds(anchors.master_stamp)},
          {"master", toJson(anchors.master)},
          {"slave_setpoint", toJson(anchors.slave_setpoint)},
          {"scale", anchors.scale},
          {"view", toJson(Eigen::Isometry3d(anchors.view))},
          {"rotation_locked", anchors.rotation_locked},
          {"translation_locked", anchors.translation_locked}};
}

Json toJson(const ClutchNews& news) {
  return {{"clutched", news.pressed}, {"stamp", suture::toNanoseconds(news.stamp)}};
}

Json toJson(const StopNews& news) {
  return {{"pressed", news.pressed}, {"stamp", suture::toNanoseconds(news.stamp)}};
}

FollowAnchors toAnchors(const Json& json) {
  return {.master_stamp = stampOf(json.at("master_stamp")),
          .master = toPose(json.at("master")),
          .slave_setpoint = toPose(json.at("slave_setpoint")),
          .scale = json.at("scale").get<double>(),
          .entry = json.at("followed").get<std::uint64_t>(),
          .view = toPose(json.at("view")).linear(),
          .rotation_locked = json.at("rotation_locked").get<bool>(),
          .translation_locked = json.at("translation_locked").get<bool>()};
}

void add(Recording& recording, const Json& json) {
  if (json.contains("followed")) {
    recording.followed.push_back(toAnchors(json));
  } else if (json.contains("clutched")) {
    recording.clutch.push_back({json.at("clutched").get<bool>(), stampOf(json.at("stamp"))});
  } else if (json.contains("pressed")) {
    recording.stops.push_back({json.at("pressed").get<bool>(), stampOf(json.at("stamp"))});
  } else {
    recording.arm.push_back({stampOf(json.at("stamp")), toPose(json.at("measured")),
                             stampOf(json.at("goal_stamp")), toPose(json.at("setpoint")),
                             json.at("enabled").get<bool>()});
  }
}

}  // namespace

void write(std::ostream& out, const Record& record) {
  out << std::visit([](const auto& value) { return toJson(value); }, record) << '\n';
}

Recording RecordingReader::next() {
  Recording recording;
  lines_.next([&](const Json& json) { add(recording, json); });
  recording.lost = lines_.lost();
  return recording;
}

Recording RecordingReader::rest() {
  Recording recording;
  lines_.rest([&](const Json& json) { add(recording, json); });
  recording.lost = lines_.lost();
  return recording;
}

Recording readRecording(const std::filesystem::path& file) { return RecordingReader(file).rest(); }

}  // namespace robots
