// Written by suturec from reference/arm_like.h. Do not edit.
#include "reference/arm_like.suture.h"



namespace reference {
namespace {

// What g++ compiles must be what suturec read.
static_assert(std::is_same_v<decltype(PoseStamped::pose), Eigen::Isometry3d>);
static_assert(std::is_same_v<decltype(PoseStamped::stamp), suture::Time>);
static_assert(std::is_same_v<decltype(PoseStamped::valid), bool>);
static_assert(std::is_same_v<decltype(JointState::name), std::vector<std::string>>);
static_assert(std::is_same_v<decltype(JointState::position), std::vector<double>>);

using suture::CommandInfo;
using suture::CommandKind;
using suture::Duration;
using suture::EventInfo;

constexpr CommandInfo kArmLikeCommands[] = {
    {.name = "servo_cp",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(ArmLikeServoCpArguments),
     .resultSize = 0,
     .depth = 16,
     .latest = true,
     .ttl = Duration(50'000'000),
     .column = -1},
    {.name = "servo_jp",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(ArmLikeServoJpArguments),
     .resultSize = 0,
     .depth = 16,
     .latest = true,
     .ttl = Duration(0),
     .column = -1},
    {.name = "hold",
     .kind = CommandKind::Void,
     .argumentsSize = 0,
     .resultSize = 0,
     .depth = 4,
     .latest = false,
     .ttl = Duration(0),
     .column = -1},
    {.name = "set_mode",
     .kind = CommandKind::Write,
     .argumentsSize = sizeof(ArmLikeSetModeArguments),
     .resultSize = 0,
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = -1},
    {.name = "measured_cp",
     .kind = CommandKind::Read,
     .argumentsSize = 0,
     .resultSize = sizeof(PoseStampedSlot),
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = 0},
    {.name = "measured_js",
     .kind = CommandKind::Read,
     .argumentsSize = 0,
     .resultSize = sizeof(JointStateSlot),
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = 1},
    {.name = "distance",
     .kind = CommandKind::QualifiedRead,
     .argumentsSize = sizeof(ArmLikeDistanceArguments),
     .resultSize = sizeof(double),
     .depth = 16,
     .latest = false,
     .ttl = Duration(0),
     .column = -1},
};

constexpr EventInfo kArmLikeEvents[] = {
    {.name = "mode",
     .payloadSize = sizeof(std::uint8_t),
     .depth = 16,
     .latest = false,
     .latched = true},
    {.name = "arrived",
     .payloadSize = sizeof(PoseStampedSlot),
     .depth = 4,
     .latest = false,
     .latched = false},
    {.name = "stopped", .payloadSize = 0, .depth = 16, .latest = false, .latched = false},
};

// The self-description, as in arm_like.suture.json.
constexpr char kArmLikeDescription[] = R"json({"name": "reference::ArmLike"})json";

}  // namespace
}  // namespace reference

namespace suture {

template <>
const InterfaceInfo& interfaceInfo<reference::ArmLike>() {
  static constexpr InterfaceInfo kInfo{
      .name = "reference::ArmLike",
      .hash = "reference",
      .description = reference::kArmLikeDescription,
      .commands = reference::kArmLikeCommands,
      .events = reference::kArmLikeEvents,
      .binding = nullptr,
  };
  return kInfo;
}

Errc Provided<reference::ArmLike>::execute(std::uint16_t command, const std::byte* arguments,
                                           std::byte* result) {
  using reference::ArmLikeCommand;
  switch (static_cast<ArmLikeCommand>(command)) {
    case ArmLikeCommand::servo_cp: {
      const auto& slot = *reinterpret_cast<const reference::ArmLikeServoCpArguments*>(arguments);
      load(slot.goal, scratch_.servo_cp_goal);
      implementation_.servo_cp(scratch_.servo_cp_goal);
      return Errc{};
    }
    case ArmLikeCommand::servo_jp: {
      const auto& slot = *reinterpret_cast<const reference::ArmLikeServoJpArguments*>(arguments);
      load(slot.goal, scratch_.servo_jp_goal);
      implementation_.servo_jp(scratch_.servo_jp_goal);
      return Errc{};
    }
    case ArmLikeCommand::hold: {
      implementation_.hold();
      return Errc{};
    }
    case ArmLikeCommand::set_mode: {
      const auto& slot = *reinterpret_cast<const reference::ArmLikeSetModeArguments*>(arguments);
      load(slot.mode, scratch_.set_mode_mode);
      implementation_.set_mode(scratch_.set_mode_mode);
      return Errc{};
    }
    case ArmLikeCommand::measured_cp: {
      auto& slot = *reinterpret_cast<reference::PoseStampedSlot*>(result);
      return store(implementation_.measured_cp(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmLikeCommand::measured_js: {
      auto& slot = *reinterpret_cast<reference::JointStateSlot*>(result);
      return store(implementation_.measured_js(), slot) ? Errc{} : Errc::TooLarge;
    }
    case ArmLikeCommand::distance: {
      const auto& slot = *reinterpret_cast<const reference::ArmLikeDistanceArguments*>(arguments);
      load(slot.to, scratch_.distance_to);
      auto& answer = *reinterpret_cast<double*>(result);
      return store(implementation_.distance(scratch_.distance_to), answer) ? Errc{} : Errc::TooLarge;
    }
  }
  return Errc::Invalid;
}

}  // namespace suture
