#include "bench/figures/report.h"

namespace bench {

void Report::add(const std::string& figure, const std::string& unit, const Statistics& statistics) {
  figures_[figure] = {
      {"unit", unit},          {"count", statistics.count}, {"mean", statistics.mean},
      {"std", statistics.std}, {"min", statistics.min},     {"p50", statistics.p50},
      {"p99", statistics.p99}, {"p99.9", statistics.p999},  {"max", statistics.max}};
}

void Report::add(const std::string& figure, const std::string& unit, double value) {
  figures_[figure] = {{"unit", unit}, {"value", value}};
}

void Report::addUnavailable(const std::string& figure, const std::string& reason) {
  figures_[figure] = {{"unavailable", reason}};
}

void Report::note(const std::string& key, const nlohmann::json& value) { notes_[key] = value; }

std::optional<Value> Report::find(const std::string& name) const {
  for (const auto& [figure, content] : figures_.items()) {
    if (!content.contains("unit") || !name.starts_with(figure)) continue;
    const std::string part = name == figure               ? "value"
                             : name[figure.size()] == '.' ? name.substr(figure.size() + 1)
                                                          : "";
    if (part == "unit" || !content.contains(part)) continue;
    return Value{content[part].get<double>(), content["unit"].get<std::string>()};
  }
  return std::nullopt;
}

std::string Report::whyUnavailable(const std::string& name) const {
  for (const auto& [figure, content] : figures_.items()) {
    const bool within = name == figure || name.starts_with(figure + ".");
    if (within && content.contains("unavailable")) return content["unavailable"];
  }
  return "";
}

nlohmann::ordered_json Report::toJson() const {
  nlohmann::ordered_json json = notes_.is_null() ? nlohmann::ordered_json::object() : notes_;
  json["figures"] = figures_.is_null() ? nlohmann::ordered_json::object() : figures_;
  return json;
}

}  // namespace bench
