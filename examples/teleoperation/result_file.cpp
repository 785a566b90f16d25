#include "result_file.h"

#include <suture/base/errors.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "tables/paper_table.h"

namespace demo {
namespace {

using nlohmann::json;

json toJson(const robots::ErrorSummary& error) {
  return {{"p50", error.p50}, {"p99", error.p99}, {"max", error.max}, {"mean", error.mean}};
}

json toJson(const std::optional<double>& figure) { return figure ? json(*figure) : json(); }

json toJson(const ArmFigures& arm) {
  json out = {{"name", arm.name}, {"task", suture::toJson(arm.task)}};
  if (arm.following) {
    out["follows"] = arm.master;
    out["position_error"] = toJson(arm.following->position);
    out["orientation_error"] = toJson(arm.following->orientation);
    out["equal_time_error"] = toJson(arm.following->equal_time);
    out["speed_times_latency"] = arm.following->speed_times_latency;
    out["travel"] = arm.following->travel;
    out["followed"] = arm.following->followed.share;
    out["compared"] = arm.following->compared;
    out["unmatched"] = arm.following->unmatched;
  }
  if (arm.jumps) {
    out["largest_jump"] = arm.jumps->setpoint.largest;
    out["largest_turn"] = arm.jumps->setpoint.largest_turn;
    out["astray"] = arm.jumps->astray;
  }
  return out;
}

}  // namespace

void writeResult(const std::filesystem::path& file, const Options& options, const Plan& plan,
                 const Network& network, const CrewResult& result, const Verdict& verdict) {
  json out = {{"topology", plan.name()},
              {"lane", options.lane},
              {"network", network.name()},
              {"rate", options.rate},
              {"seconds", std::chrono::duration<double>(result.ran).count()},
              {"interrupted", result.interrupted},
              {"failures", result.failures},
              {"passed", verdict.passed() && !result.interrupted},
              {"programs", json::array()},
              {"ages", PaperTable(plan, verdict.connections).figures()},
              {"connections", json::array()},
              {"arms", json::array()},
              {"processes", json::array()},
              {"held", json::array()},
              {"checks", json::array()}};
  for (const ProgramHash& one : result.programs) {
    out["programs"].push_back({{"name", one.name}, {"sha256", one.sha256}});
  }
  for (const HeldSlave& slave : verdict.held) {
    out["held"].push_back({{"name", slave.name},
                           {"held_after", slave.judgement.held_after},
                           {"resumed_after", toJson(slave.judgement.resumed_after)},
                           {"largest_jump", slave.judgement.jumps.largest},
                           {"largest_turn", slave.judgement.jumps.largest_turn}});
  }
  if (verdict.knot) {
    out["knot"] = {{"start", verdict.knot->start},
                   {"error", verdict.knot->error},
                   {"guided_at_end", verdict.knot->guided_at_end},
                   {"sighted", verdict.knot->sighted},
                   {"sighting_error", verdict.knot->sighting_error},
                   {"outside", toJson(verdict.knot->outside)},
                   {"depth", toJson(verdict.knot->depth)},
                   {"contact", toJson(verdict.knot->contact)},
                   {"rows", verdict.knot->rows}};
  }
  for (const auto& one : verdict.connections) out["connections"].push_back(suture::toJson(one));
  for (const auto& one : verdict.arms) out["arms"].push_back(toJson(one));
  for (const auto& one : result.reports) out["processes"].push_back(suture::toJson(one));
  for (const auto& one : verdict.checks) {
    out["checks"].push_back({{"passed", one.passed}, {"text", one.text}});
  }
  std::ofstream stream(file);
  stream << out.dump(2) << '\n';
  if (!stream) {
    throw suture::SetupError("writing the result to " + file.string(), "the file cannot be written",
                             "Name a file in an existing folder that you may write to");
  }
}

}  // namespace demo
