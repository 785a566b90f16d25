#include <suture/base/nearest.h>
#include <suture/component/factory/json_reader.h>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

constexpr unsigned kDeepest = 64;

std::string child(const std::string& pointer, const std::string& key) {
  return (nlohmann::json::json_pointer(pointer) / key).to_string();
}

/// Returns "63" of 63.0, which is a bound of whole numbers too. JSON has no infinity.
std::string shortest(double number) {
  if (std::isinf(number)) return number > 0 ? "infinity" : "-infinity";
  std::string text = nlohmann::json(number).dump();
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

}  // namespace

void JsonReader::expected(std::string_view what) const {
  report("expected " + std::string(what) + ", found " + json_.type_name() + " " + json_.dump());
}

void JsonReader::checkRange(double lowest, double highest) const {
  if (tooDeep()) return;
  if (json_.is_array()) {
    for (std::size_t i = 0; i < json_.size(); ++i) at(i).checkRange(lowest, highest);
  } else if (json_.is_object()) {
    for (const auto& [key, value] : json_.items()) at(key).checkRange(lowest, highest);
  } else if (json_.is_number()) {
    isWithin(lowest, highest, "a number");
  }
}

bool JsonReader::isWithin(double lowest, double highest, std::string_view what) const {
  const double number = json_.get<double>();
  if (number >= lowest && number <= highest) return true;
  expected(std::string(what) + " from " + shortest(lowest) + " to " + shortest(highest));
  return false;
}

void JsonReader::tooShort(double tick) const {
  expected("a number of seconds that is 0 or at least " + shortest(tick));
}

JsonReader JsonReader::at(const std::string& key) const {
  return below(json_.at(key), child(pointer_, key));
}

JsonReader JsonReader::at(std::size_t index) const {
  return below(json_.at(index), pointer_ + "/" + std::to_string(index));
}

JsonReader JsonReader::below(const nlohmann::json& json, std::string pointer) const {
  JsonReader reader(json, std::move(pointer), problems_);
  reader.depth_ = depth_ + 1;
  return reader;
}

bool JsonReader::tooDeep() const {
  if (depth_ <= kDeepest) return false;
  report("nested more than " + std::to_string(kDeepest) + " deep");
  return true;
}

bool JsonReader::isArrayOf(std::size_t size) const {
  return json_.is_array() && json_.size() == size;
}

void JsonReader::finish() const {
  if (!json_.is_object()) return expected("an object");
  for (const auto& [key, value] : json_.items()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::string nearest = nearestName(key, known_);
    problems_.push_back(
        {child(pointer_, key), "unknown key '" + key + "'" +
                                   (nearest.empty() ? "; known are " + listNames(known_)
                                                    : "; did you mean '" + nearest + "'?")});
  }
}

void fromJson(const JsonReader& in, bool& value) {
  if (!in.json().is_boolean()) return in.expected("true or false");
  value = in.json().get<bool>();
}

void fromJson(const JsonReader& in, std::string& value) {
  if (!in.json().is_string()) return in.expected("a string");
  value = in.json().get<std::string>();
}

void fromJson(const JsonReader& in, std::byte& value) {
  std::uint8_t number = 0;
  fromJson(in, number);
  value = std::byte{number};
}

namespace {

template <class Transform>
void readTransform(const JsonReader& in, const char* linear, Transform& value) {
  JsonReader reader = in;
  Eigen::Matrix3d rotation = value.linear();
  Eigen::Vector3d translation = value.translation();
  reader.field(linear, rotation);
  reader.field("translation", translation);
  reader.finish();
  value.linear() = rotation;
  value.translation() = translation;
}

}  // namespace

void fromJson(const JsonReader& in, Eigen::Isometry3d& value) {
  readTransform(in, "rotation", value);
}

void fromJson(const JsonReader& in, Eigen::Affine3d& value) { readTransform(in, "linear", value); }

int enumeratorFromJson(const JsonReader& in, const std::vector<std::string>& names) {
  const auto found = in.json().is_string()
                         ? std::find(names.begin(), names.end(), in.json().get<std::string>())
                         : names.end();
  if (found != names.end()) return static_cast<int>(found - names.begin());
  in.expected("one of " + listNames(names));
  return -1;
}

}  // namespace suture
