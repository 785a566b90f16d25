#pragma once
// This is the console of a telesurgical robot, as the kind of nested configuration that grows in a
// lab: structs in structs, several namespaces, optionals, maps.

#include <suture/annotate.h>

#include <Eigen/Geometry>
#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace lab::arm {

/// Which kind of arm it is.
enum class SUTURE_TYPE() Kind : std::uint8_t { MTM, PSM, ECM, SUJ };

/// One joint, and how its encoder and its amplifier are read.
struct SUTURE_TYPE() Joint {
  enum class SUTURE_TYPE() Type { Revolute, Prismatic };

  struct SUTURE_TYPE() Encoder {
    std::int32_t counts_per_turn = 4096;
    SUTURE_FIELD(unit("V")) std::array<double, 2> potentiometer{};
    bool reversed = false;
  };

  struct SUTURE_TYPE() Limits {
    SUTURE_FIELD(range(-std::numeric_limits<double>::infinity(), 0))
    double lower = -std::numeric_limits<double>::infinity();
    SUTURE_FIELD(range(0, std::numeric_limits<double>::infinity()))
    double upper = std::numeric_limits<double>::infinity();
    SUTURE_FIELD(unit("N.m")) float effort = 0.25f;
  };

  SUTURE_FIELD(capacity(12)) std::string name;
  Type type = Type::Revolute;
  Encoder encoder;
  std::optional<Limits> limits;
};

/// An arm of the console.
struct SUTURE_TYPE(name("ArmConfiguration")) Configuration {
  struct SUTURE_TYPE() Tool {
    SUTURE_FIELD(capacity(12)) std::string model;
    Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();
    std::pair<double, double> jaw{0, 1};
  };

  Kind kind = Kind::PSM;
  SUTURE_FIELD(capacity(7)) std::vector<Joint> joints;
  SUTURE_FIELD(capacity(3, 8)) std::map<std::string, Tool> tools;
  std::chrono::milliseconds period{1};
};

}  // namespace lab::arm

namespace lab::console {

/// A hand moves one arm, and another follows.
struct SUTURE_TYPE() Teleoperation {
  /// What the follower does with what the hand says.
  struct SUTURE_TYPE() Scaling {
    SUTURE_FIELD(range(0, 1)) double factor = 0.2;
    bool rotation_locked = false;
  };
  /// Nothing is scaled, and the hand sets a velocity.
  struct SUTURE_TYPE() Rate {
    SUTURE_FIELD(unit("m/s")) double fastest = 0.1;
  };

  SUTURE_FIELD(capacity(8)) std::string master;
  SUTURE_FIELD(capacity(8)) std::string slave;
  std::variant<std::monostate, Scaling, Rate> mapping;
};

/// All of it.
struct SUTURE_TYPE() Configuration {
  enum class SUTURE_TYPE() Pedal { Clutch, Camera, Coag = 10, Bicoag };

  SUTURE_FIELD(capacity(4, 8)) std::map<std::string, arm::Configuration> arms;
  SUTURE_FIELD(capacity(3)) std::vector<Teleoperation> pairs;
  SUTURE_FIELD(capacity(4)) std::map<Pedal, std::int32_t> pins;
  std::optional<Eigen::Quaterniond> camera;
};

/// Sets up the console and hears of its pedals.
class SUTURE_INTERFACE() Console {
 public:
  virtual ~Console() = default;
  SUTURE_COMMAND(queue(2)) virtual void configure(const Configuration& configuration) = 0;
  SUTURE_COMMAND() virtual const arm::Configuration& first() const = 0;
  SUTURE_COMMAND() virtual Configuration::Pedal pressed() const = 0;
  SUTURE_EVENT(queue(4)) suture::EventOf<Teleoperation, Configuration::Pedal> engaged;
  SUTURE_EVENT(queue(4)) suture::EventOf<arm::Joint::Type, arm::Joint> limited;
};

}  // namespace lab::console
