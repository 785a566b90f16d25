#include <suture/observe/report.h>

namespace suture {

NLOHMANN_JSON_SERIALIZE_ENUM(ConnectionEnd, {{ConnectionEnd::Client, "client"},
                                             {ConnectionEnd::Provider, "provider"},
                                             {ConnectionEnd::Both, "both"}})
NLOHMANN_JSON_SERIALIZE_ENUM(ChannelStatus, {{ChannelStatus::Connected, "connected"},
                                             {ChannelStatus::Lost, "lost"},
                                             {ChannelStatus::Faulted, "faulted"},
                                             {ChannelStatus::Closed, "closed"},
                                             {ChannelStatus::Suspended, "suspended"},
                                             {ChannelStatus::Lapsed, "lapsed"}})
NLOHMANN_JSON_SERIALIZE_ENUM(ComponentState, {{ComponentState::Constructed, "constructed"},
                                              {ComponentState::Configured, "configured"},
                                              {ComponentState::Running, "running"},
                                              {ComponentState::Suspended, "suspended"},
                                              {ComponentState::Faulted, "faulted"},
                                              {ComponentState::Stopped, "stopped"}})

namespace {

using nlohmann::json;

// Lists the fields once for both directions: calls Visit with each field's key and value.
template <class Distributed, class Visit>
void eachField(Distributed& value, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<Distributed>, Distribution> {
  visit("count", value.count);
  visit("p50", value.p50);
  visit("p99", value.p99);
  visit("max", value.max);
}

template <class Summary, class Visit>
void eachField(Summary& value, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<Summary>, DurationSummary> {
  visit("mean", value.mean);
  visit("deviation", value.deviation);
  visit("min", value.min);
  visit("max", value.max);
  visit("p99", value.p99);
}

template <class Window, class Visit>
void eachField(Window& value, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<Window>, WindowReport> {
  visit("length", value.length);
  visit("cycles", value.cycles);
  visit("skipped", value.skipped);
  visit("period", value.period);
  visit("compute", value.compute);
}

template <class Contract, class Visit>
void eachField(Contract& value, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<Contract>, ContractReport> {
  visit("stale_reads", value.staleReads);
  visit("losses", value.losses);
  visit("awaits_operator", value.awaitsOperator);
}

template <class Counts, class Visit>
void eachField(Counts& value,
               const Visit& visit) requires std::is_same_v<std::remove_const_t<Counts>, Tally> {
  visit("executed", value.executed);
  visit("late", value.late);
  visit("refused", value.refused);
  visit("failed", value.failed);
  visit("replaced", value.replaced);
  visit("superseded", value.superseded);
  visit("cancelled", value.cancelled);
  visit("events_dropped", value.eventsDropped);
}

Tally& tallyIn(ConnectionReport& report) { return report; }
const Tally& tallyIn(const ConnectionReport& report) { return report; }

template <class Connection, class Visit>
void eachField(Connection& value, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<Connection>, ConnectionReport> {
  visit("name", value.name);
  visit("lane", value.lane);
  visit("lane_reason", value.laneReason);
  visit("clock_shift", value.clockShift);
  visit("clock_error", value.clockError);
  visit("end", value.end);
  visit("status", value.status);
  visit("why_lost", value.whyLost);
  visit("why_not_back", value.whyNotBack);
  visit("bytes_sent", value.bytesSent);
  visit("bytes_received", value.bytesReceived);
  visit("contract", value.contract);
  eachField(tallyIn(value), visit);
  visit("sent", value.sent);
  visit("full", value.full);
  visit("too_large", value.tooLarge);
  visit("invalid", value.invalid);
  visit("last_invalid", value.lastInvalid);
  visit("lost", value.lost);
  visit("unknown", value.unknown);
  visit("under_way", value.underWay);
  visit("heard", value.heard);
  visit("other_incarnation", value.otherIncarnation);
  visit("events_delivered", value.eventsDelivered);
  visit("messages_lost", value.messagesLost);
  visit("messages_duplicated", value.messagesDuplicated);
  visit("messages_overtaken", value.messagesOvertaken);
  visit("read_age", value.readAge);
  visit("command_age", value.commandAge);
}

template <class TaskValue, class Visit>
void eachField(TaskValue& value, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<TaskValue>, TaskReport> {
  visit("name", value.name);
  visit("state", value.state);
  visit("fault", value.fault);
  visit("faults", value.faults);
  visit("scheduling", value.scheduling);
  visit("cycles", value.cycles);
  visit("skipped", value.skipped);
  visit("lateness", value.lateness);
  visit("compute_time", value.computeTime);
  visit("processor_time", value.processorTime);
  visit("window", value.window);
}

template <class Device, class Visit>
void eachField(Device& value, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<Device>, DeviceReport> {
  visit("name", value.name);
  visit("state", value.state);
  visit("fault", value.fault);
  visit("faults", value.faults);
}

template <class Summary, class Visit>
void eachField(Summary& value, const Visit& visit) requires
    std::is_same_v<std::remove_const_t<Summary>, net::Refusals::Summary> {
  visit("count", value.count);
  visit("latest", value.latest);
}

template <class Value>
constexpr bool kIsPart =
    std::is_same_v<Value, Distribution> || std::is_same_v<Value, DurationSummary> ||
    std::is_same_v<Value, WindowReport> || std::is_same_v<Value, ContractReport> ||
    std::is_same_v<Value, Tally>;

template <class Value>
json fieldToJson(const Value& value) {
  if constexpr (std::is_same_v<Value, Duration>) {
    return value.count();
  } else if constexpr (kIsPart<Value>) {
    json out;
    eachField(value, [&](const char* key, const auto& field) { out[key] = fieldToJson(field); });
    return out;
  } else {
    return value;
  }
}

template <class Value>
json fieldToJson(const std::optional<Value>& value) {
  return value ? fieldToJson(*value) : json(nullptr);
}

template <class Value>
void fieldFromJson(const json& in, Value& value) {
  if constexpr (std::is_same_v<Value, Duration>) {
    value = Duration(in.get<std::int64_t>());
  } else if constexpr (kIsPart<Value>) {
    eachField(value, [&](const char* key, auto& field) { fieldFromJson(in.at(key), field); });
  } else {
    in.get_to(value);
  }
}

template <class Value>
void fieldFromJson(const json& in, std::optional<Value>& value) {
  if (!in.is_null()) fieldFromJson(in, value.emplace());
}

template <class Value>
json structToJson(const Value& value) {
  json out;
  eachField(value, [&](const char* key, const auto& field) { out[key] = fieldToJson(field); });
  return out;
}

template <class Value>
Value structFromJson(const json& in) {
  Value value;
  eachField(value, [&](const char* key, auto& field) { fieldFromJson(in.at(key), field); });
  return value;
}

}  // namespace

json toJson(const ConnectionReport& report) {
  json out = structToJson(report);
  out["dropped"] = report.dropped();
  return out;
}
json toJson(const TaskReport& report) { return structToJson(report); }
json toJson(const DeviceReport& report) { return structToJson(report); }

json toJson(const Report& report) {
  json out = {{"process", report.process},    {"incarnation", report.incarnation},
              {"age", report.age.count()},    {"processor_time", report.processorTime.count()},
              {"connections", json::array()}, {"tasks", json::array()},
              {"devices", json::array()}};
  for (const ConnectionReport& one : report.connections) out["connections"].push_back(toJson(one));
  for (const TaskReport& one : report.tasks) out["tasks"].push_back(toJson(one));
  for (const DeviceReport& one : report.devices) out["devices"].push_back(toJson(one));
  out["refusals"] = structToJson(report.refusals);
  return out;
}

Report reportFromJson(const json& in) {
  Report report{in.at("process"), Duration(in.at("age").get<std::int64_t>()), {}, {}, {}};
  for (const json& one : in.at("connections")) {
    report.connections.push_back(structFromJson<ConnectionReport>(one));
  }
  for (const json& one : in.at("tasks")) report.tasks.push_back(structFromJson<TaskReport>(one));
  for (const json& one : in.at("devices")) {
    report.devices.push_back(structFromJson<DeviceReport>(one));
  }
  report.incarnation = in.at("incarnation").get<std::uint64_t>();
  report.processorTime = Duration(in.at("processor_time").get<std::int64_t>());
  report.refusals = structFromJson<net::Refusals::Summary>(in.at("refusals"));
  return report;
}

}  // namespace suture
