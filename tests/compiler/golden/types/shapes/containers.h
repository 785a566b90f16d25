#pragma once
// Every container that has a wire form, with and without the bounds that a slot needs.

#include <suture/annotate.h>

#include <Eigen/Geometry>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace shapes {

/// Sparse, negative, and ready for what later versions add.
enum class SUTURE_TYPE() Level : std::int16_t {
  Unknown SUTURE_FIELD(fallback()) = -1,
  Low = 10,
  High = 300
};

/// Parts of other types.
struct SUTURE_TYPE() Point {
  SUTURE_FIELD(unit("m"), range(-10, 10)) double x = 0;
  double y = 0;
};

/// Sequences, sets and maps.
struct SUTURE_TYPE() Sequences {
  SUTURE_FIELD(capacity(8)) std::vector<std::byte> bytes;
  std::byte one{};
  double row[3] = {};
  std::int32_t grid[2][3] = {};
  Point corners[2];
  SUTURE_FIELD(capacity(3)) std::deque<Point> path;
  SUTURE_FIELD(capacity(4)) std::deque<bool> bits;
  SUTURE_FIELD(capacity(4)) std::vector<bool> flags;
  SUTURE_FIELD(capacity(4)) std::set<std::int32_t, std::less<>> numbers;
  SUTURE_FIELD(capacity(3, 6)) std::unordered_set<std::string> words;
  SUTURE_FIELD(capacity(3)) std::set<Level> levels;
  SUTURE_FIELD(capacity(3, 6)) std::map<std::string, double, std::less<>> gains;
  SUTURE_FIELD(capacity(3)) std::unordered_map<std::uint16_t, Point> points;
  SUTURE_FIELD(capacity(2, 4, 3)) std::map<std::string, std::vector<float>> series;
  SUTURE_FIELD(capacity(3), range(0, 1)) std::map<Level, double> shares;
};

/// What holds one thing or another, or some of each.
struct SUTURE_TYPE() Choices {
  std::optional<double> gain;
  SUTURE_FIELD(range(0, 1)) std::optional<double> share;
  std::optional<bool> answer;
  SUTURE_FIELD(capacity(8)) std::optional<std::string> frame;
  std::optional<Point> target;
  SUTURE_FIELD(capacity(2)) std::optional<std::vector<Point>> polygon;
  std::optional<std::optional<std::int32_t>> twice;
  SUTURE_FIELD(capacity(3)) std::vector<std::optional<Eigen::Vector3d>> seen;
  std::pair<std::int32_t, double> entry;
  SUTURE_FIELD(capacity(4)) std::tuple<bool, std::string, Point> triple;
  SUTURE_FIELD(capacity(4)) std::variant<std::monostate, double, Point, std::string, double> either;
  std::variant<Level, std::optional<Point>> nested;
  std::unique_ptr<Point> owned;
  std::pair<double, Level> rated;
};

/// Eigen types of all kinds.
struct SUTURE_TYPE() Matrices {
  SUTURE_FIELD(capacity(4), unit("rad")) Eigen::VectorXd joints;
  SUTURE_FIELD(capacity(3)) Eigen::RowVectorXd row;
  SUTURE_FIELD(capacity(2, 3)) Eigen::MatrixXd any;
  SUTURE_FIELD(capacity(2, 2)) Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic> counts;
  SUTURE_FIELD(capacity(4)) Eigen::Matrix<double, 3, Eigen::Dynamic> columns;
  Eigen::Matrix<float, Eigen::Dynamic, 1, 0, 5, 1> limited;
  Eigen::Matrix<double, 4, 5> fixed = Eigen::Matrix<double, 4, 5>::Zero();
  SUTURE_FIELD(capacity(3)) std::vector<Eigen::Vector3d> cloud;
  SUTURE_FIELD(capacity(3)) std::deque<Eigen::Matrix<float, 6, 1>> wrenches;
  Eigen::Affine3d scaled = Eigen::Affine3d::Identity();
  std::chrono::duration<double, std::milli> wait{0};
};

/// Composites right in a contract.
class SUTURE_INTERFACE() Store {
 public:
  virtual ~Store() = default;
  SUTURE_COMMAND() virtual void put(const Sequences& value) = 0;
  SUTURE_COMMAND() virtual void choose(const std::optional<double>& gain) = 0;
  SUTURE_COMMAND() virtual const Sequences& sequences() const = 0;
  SUTURE_COMMAND() virtual const Choices& choices() const = 0;
  SUTURE_COMMAND() virtual const Matrices& matrices() const = 0;
  SUTURE_COMMAND() virtual std::pair<double, Level> reading() const = 0;
  SUTURE_EVENT() suture::EventOf<std::variant<double, Point>> changed;
};

}  // namespace shapes
