#pragma once
// A report says in numbers what a process does: its connections, tasks and devices at one moment,
// counted from their start. These are plain values, which belong to whoever has made them.

#include <suture/base/time.h>
#include <suture/component/channel/channel.h>
#include <suture/component/channel/counts/tally.h>
#include <suture/component/component.h>
#include <suture/component/task/task_window.h>
#include <suture/net/refusals.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// Says how durations are distributed.
struct Distribution {
  std::uint64_t count = 0;
  Duration p50{}, p99{}, max{};
};

/// Says how a connection's contract (docs/safety.md) has been kept.
struct ContractReport {
  std::uint64_t staleReads = 0;  ///< reads of values older than max_age
  std::uint64_t losses = 0;      ///< how often the provider was lost or faulted
  bool awaitsOperator = false;   ///< commands are refused until an operator resumes the connection
};

/// Each end counts what it sees; the other's counters are in the report of the other's process
/// (mergeConnections() puts the two together).
///
/// Its counts are from the start of this process, or of the client's if that came later, over all
/// channels that the connection has had. Each command that was sent is one of those in Tally, or
/// lost, unknown or under way. A client's end counts what it has heard.
struct ConnectionReport : Tally {
  std::string name;  ///< "left:Teleop/Slave -> right:PSM1/Arm": the same at both ends
  std::string lane;
  std::string laneReason;  ///< why it is not a faster one that was hoped for
  /// This process adds the shift to the stamps of the other; that, and so an age, may be wrong by
  /// the error, either way. It is zero if both have one clock.
  Duration clockShift{0}, clockError{0};
  ConnectionEnd end = ConnectionEnd::Both;
  ChannelStatus status = ChannelStatus::Connected;
  std::string whyLost;  ///< the last time, at the client's end: "silent: ..."; "" if it never was
  /// Says why the client's end, which is lost, cannot be made anew; "": it is not lost, or may be.
  std::string whyNotBack;
  std::uint64_t bytesSent = 0, bytesReceived = 0;  ///< on the wire; 0 within a process

  /// The client's end has it. There is none at the provider's end, or for a connection without a
  /// contract.
  std::optional<ContractReport> contract;

  std::uint64_t sent = 0;  ///< commands that the client's calls handed over; at the provider's end
                           ///< alone: that the lane did
  std::uint64_t full = 0;  ///< refused: too many waited
  std::uint64_t tooLarge = 0;  ///< refused: beyond a declared capacity
  std::uint64_t invalid = 0;   ///< refused: the contract does not admit such values
  /// Names the part of a value that this end refused last: "servo_cp.goal.pose"; "": none was.
  std::string lastInvalid;
  std::uint64_t lost = 0;      ///< they did not reach the provider in time, and it says so
  std::uint64_t unknown = 0;   ///< at the client's end: a lost provider may have executed them
  std::uint64_t underWay = 0;  ///< no outcome yet, or at the client's end none that it has heard of
  Tally heard;                 ///< the part of its tally that a client's end has been told
  std::uint64_t otherIncarnation = 0;  ///< which start of the process at the other end
  std::uint64_t eventsDelivered = 0;
  /// Count messages either way that the lane lost, brought twice, or brought after newer ones
  /// (which are among the lost, too), as the client's end knows. None has had an effect.
  std::uint64_t messagesLost = 0, messagesDuplicated = 0, messagesOvertaken = 0;

  Distribution readAge;     ///< how old values were when the client read them
  Distribution commandAge;  ///< how old commands were when the provider executed them

  /// Counts, at the ends that are seen, commands that were neither executed, nor late, nor replaced
  /// by a newer one of the same kind.
  std::uint64_t dropped() const {
    return full + tooLarge + invalid + superseded + refused + cancelled;
  }
};

/// A WindowReport is a window of a task's cycles, as TaskWindow has it; all zero before the first.
struct WindowReport {
  Duration length{};
  std::uint64_t cycles = 0, skipped = 0;
  DurationSummary period, compute;
};

struct TaskReport {
  std::string name;
  ComponentState state = ComponentState::Constructed;
  std::string fault;         ///< why it was faulted, in words, if state is Faulted
  std::uint64_t faults = 0;  ///< how often it has been faulted
  std::string scheduling;    ///< "fifo 80 on processor 1"; "": another's thread runs it
  std::uint64_t cycles = 0, skipped = 0;
  Distribution lateness;  ///< wake-up time minus due time: the jitter of the period
  Distribution computeTime;
  /// Its thread has used this much processor time; there is none if another's thread runs it.
  std::optional<Duration> processorTime = {};
  WindowReport window;  ///< the last whole one
};

struct DeviceReport {
  std::string name;
  ComponentState state = ComponentState::Constructed;
  std::string fault;  ///< why it was faulted, in words, if state is Faulted
  std::uint64_t faults = 0;
};

struct Report {
  std::string process;
  Duration age{};  ///< since the process began to observe itself
  std::vector<ConnectionReport> connections;
  std::vector<TaskReport> tasks;
  std::vector<DeviceReport> devices = {};
  net::Refusals::Summary refusals = {};  ///< peers, and requests of peers
  std::uint64_t incarnation = 0;         ///< which start of the process; 0 without a global manager
  Duration
      processorTime{};  ///< of all its threads: those of tasks, and those that carry connections
};

/// Any thread. Turn a report into JSON: durations become whole nanoseconds, "dropped" stands beside
/// what it is the sum of, and a contract that is not there is null. docs/howto/reports.md explains
/// each field.
nlohmann::json toJson(const ConnectionReport& report);
nlohmann::json toJson(const TaskReport& report);
nlohmann::json toJson(const DeviceReport& report);
nlohmann::json toJson(const Report& report);
/// Reads what toJson() wrote. Throws nlohmann::json::exception for anything else.
Report reportFromJson(const nlohmann::json& json);

}  // namespace suture
