#pragma once
// These types have no bounds: they are for devices.

#include <suture/annotate.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "shapes/containers.h"

namespace shapes {

struct Branch;

/// Holds itself, and another that holds it.
struct SUTURE_TYPE() Root {
  std::int32_t value = 0;
  std::vector<Root> children;
  std::unique_ptr<Root> shadow;
  std::vector<Branch> branches;
};
struct SUTURE_TYPE() Branch {
  SUTURE_FIELD(unit("m"), range(0, 10)) double length = 0;
  std::map<std::string, Root> roots;
};

/// Each level that may lack its bound, all of it or a part.
struct SUTURE_TYPE() Open {
  std::string name;
  std::vector<double> samples;
  std::vector<std::uint8_t> bytes;
  SUTURE_FIELD(bulk()) std::vector<float> block;
  std::vector<bool> flags;
  std::deque<Point> path;
  std::array<std::string, 2> pair;
  SUTURE_FIELD(capacity(2)) std::vector<std::string> words;
  SUTURE_FIELD(capacity(0, 3)) std::vector<std::string> shorts;
  std::set<std::string> keys;
  std::map<std::string, std::vector<Point>> series;
  std::optional<std::string> note;
  std::variant<std::monostate, std::string, Point> either;
  std::tuple<std::int32_t, std::string> entry;
  Eigen::VectorXd joints;
  SUTURE_FIELD(range(-1, 1)) Eigen::MatrixXd any;
  SUTURE_FIELD(capacity(2, 0)) Eigen::MatrixXd wide;
  std::vector<Eigen::Vector3d> cloud;
  SUTURE_FIELD(bulk()) Eigen::MatrixXd image;
  Root root;
};

/// What a device may offer.
class SUTURE_INTERFACE() Archive {
 public:
  virtual ~Archive() = default;
  /// Keeps `value` under `key`.
  SUTURE_COMMAND() virtual void put(const std::string& key, const Open& value) = 0;
  SUTURE_COMMAND(latest()) virtual void remark(const std::string& text) = 0;
  SUTURE_COMMAND() virtual const Open& newest() const = 0;
  SUTURE_COMMAND() virtual std::vector<std::string> find(const std::string& pattern) const = 0;
  SUTURE_COMMAND() virtual Open replace(const Open& value) = 0;
  SUTURE_EVENT(latched()) suture::EventOf<std::string> renamed;
  SUTURE_EVENT() suture::EventOf<std::string, Root> grown;
  SUTURE_EVENT(latest()) suture::EventOf<Open> changed;
};

}  // namespace shapes
