#pragma once
// These are the operating states of an arm as CRTK defines them (collaborative-robotics.github.io),
// and what each command leads to in each state.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "robot_types/operating_state.h"

namespace robots {

enum class StateCommand : std::uint8_t { Enable, Disable, Pause, Resume, Home, Unhome };

/// The commands have these names, in their order.
constexpr std::array<std::string_view, 6> kStateCommands{"enable", "disable", "pause",
                                                         "resume", "home",    "unhome"};

/// Returns none if there is no such command.
constexpr std::optional<StateCommand> stateCommandNamed(std::string_view name) {
  const auto* const found = std::find(kStateCommands.begin(), kStateCommands.end(), name);
  if (found == kStateCommands.end()) return std::nullopt;
  return static_cast<StateCommand>(found - kStateCommands.begin());
}

/// Returns the state after `command` in `state`; none if the command is refused there, which
/// changes nothing. An arm leaves UNDEFINED by itself, when it hears of drives that may have power.
/// Only the arm itself enters FAULT, from ENABLED or PAUSED, and only enable and disable leave it.
/// resume leaves PAUSED and enable does not, so that no client ends another's pause by accident.
constexpr std::optional<ArmState> after(ArmState state, StateCommand command) {
  using enum ArmState;
  constexpr std::optional<ArmState> kNo;
  // The rows are the states in their order, the columns the commands in theirs.
  constexpr std::optional<ArmState> kTable[][kStateCommands.size()] = {
      // enable  disable   pause   resume   home     unhome
      {kNo, Undefined, kNo, kNo, kNo, Undefined},          // Undefined
      {Enabled, Disabled, kNo, kNo, kNo, Disabled},        // Disabled
      {Enabled, Disabled, Paused, kNo, Enabled, Enabled},  // Enabled
      {kNo, Disabled, kNo, Enabled, kNo, Paused},          // Paused
      {Enabled, Disabled, kNo, kNo, kNo, Fault},           // Fault
  };
  return kTable[static_cast<std::size_t>(state)][static_cast<std::size_t>(command)];
}

/// Returns for people why a command is refused for which after() returns none.
constexpr std::string_view whyRefused(ArmState state, StateCommand command) {
  if (state == ArmState::Undefined) return "the arm has not heard of drives that may have power";
  switch (command) {
    case StateCommand::Enable: return "enable: the arm is paused; resume or disable it";
    case StateCommand::Pause: return "pause: the arm is not enabled";
    case StateCommand::Resume: return "resume: the arm is not paused";
    case StateCommand::Home: return "home: the arm is not enabled";
    case StateCommand::Disable:
    case StateCommand::Unhome: break;  // these are possible in every state
  }
  return "";
}

}  // namespace robots
