#include "compiler/check/crtk.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <vector>

#include "compiler/check/rules.h"
#include "compiler/model/naming.h"

namespace suture::compiler::check {
namespace crtk {
namespace {

using Shape = model::Type::Shape;

constexpr std::array<std::string_view, 6> kNamespaces{"local_", "body_",    "spatial_",
                                                      "jaw_",   "gripper_", "actuators_"};

const std::map<std::string_view, Payload>& spaces() {
  static const std::map<std::string_view, Payload> kSpaces{
      {"js", Payload::JointState},    {"jp", Payload::Joints}, {"jr", Payload::Joints},
      {"jv", Payload::Joints},        {"jf", Payload::Joints}, {"cp", Payload::Pose},
      {"cr", Payload::Pose},          {"cv", Payload::Twist},  {"cf", Payload::Twist},
      {"cs", Payload::CartesianState}};
  return kSpaces;
}

/// Returns the spaces that a level has, or "" if it is none of CRTK's.
std::string_view spacesOf(std::string_view level) {
  const bool numbered = level.size() == 9 && std::isdigit(static_cast<unsigned char>(level[8]));
  if (level == "measured" || (numbered && level.starts_with("measured"))) return "js cp cv cf cs";
  if (level == "setpoint" || level == "goal") return "js cp cv cf cs";
  if (level == "servo") return "jp jr jv jf cp cr cv cf cs";
  if (level == "interpolate") return "jp jr jv jf cp cr cv cf";
  return level == "move" ? "jp jr cp cr" : "";
}

bool isQuery(std::string_view level) {
  return level.starts_with("measured") || level == "setpoint" || level == "goal";
}

/// These are the state machine's words, and what dVRK and cisst add to the motion commands.
const std::map<std::string_view, Meaning>& words() {
  static const std::map<std::string_view, Meaning> kWords{
      {"operating_state", {Role::Query, Payload::State}},
      {"desired_state", {Role::Other, Payload::State}},
      {"state_command", {Role::Motion, Payload::Text}},
      {"enable", {Role::Other, Payload::Any}},
      {"disable", {Role::Other, Payload::Any}},
      {"pause", {Role::Other, Payload::Any}},
      {"resume", {Role::Other, Payload::Any}},
      {"home", {Role::Other, Payload::Any}},
      {"unhome", {Role::Other, Payload::Any}},
      {"hold", {Role::Other, Payload::Any}},
      {"free", {Role::Other, Payload::Any}},
      {"servo_ci", {Role::Motion, Payload::Any}},
      {"use_gravity_compensation", {Role::Motion, Payload::Flag}},
      {"gravity_compensation", {Role::Other, Payload::Any}},
      {"set_cf_orientation_absolute", {Role::Motion, Payload::Flag}},
      {"trajectory_j_set_ratio", {Role::Motion, Payload::Any}},
      {"trajectory_j_set_ratio_v", {Role::Motion, Payload::Any}},
      {"trajectory_j_set_ratio_a", {Role::Motion, Payload::Any}},
      {"trajectory_j_ratio", {Role::Query, Payload::Any}},
      {"trajectory_j_ratio_v", {Role::Query, Payload::Any}},
      {"trajectory_j_ratio_a", {Role::Query, Payload::Any}},
      {"goal_reached", {Role::Other, Payload::Flag}},
      {"closed", {Role::Other, Payload::Flag}},
      {"base_frame", {Role::Query, Payload::Pose}},
      {"set_base_frame", {Role::Motion, Payload::Pose}},
      {"configuration_js", {Role::Query, Payload::Any}},
      {"jacobian", {Role::Query, Payload::Any}},
      {"period_statistics", {Role::Query, Payload::Any}},
      {"crtk_version", {Role::Query, Payload::Any}},
      {"forward_kinematics", {Role::Other, Payload::Any}},
      {"inverse_kinematics", {Role::Other, Payload::Any}},
      {"query_cp", {Role::Other, Payload::Any}},
      {"status", {Role::Other, Payload::Message}},
      {"warning", {Role::Other, Payload::Message}},
      {"error", {Role::Other, Payload::Message}}};
  return kWords;
}

std::optional<Meaning> plainMeaning(std::string_view name) {
  const auto word = words().find(name);
  if (word != words().end()) return word->second;
  const std::size_t split = name.rfind('_');
  if (split == std::string_view::npos) return std::nullopt;
  const std::string_view level = name.substr(0, split), space = name.substr(split + 1);
  const auto payload = spaces().find(space);
  if (payload == spaces().end() || spacesOf(level).find(space) == std::string_view::npos) {
    return std::nullopt;
  }
  return Meaning{isQuery(level) ? Role::Query : Role::Motion, payload->second};
}

bool isNumber(const model::Type& type) {
  return type.shape == Shape::Scalar && type.scalar != model::Scalar::Bool;
}

bool isVector(const model::Type& type, unsigned rows) {
  return type.shape == Shape::Matrix && type.columns == 1 && type.rows == rows;
}

/// Returns the type itself and, if it is a struct, the types of its fields.
std::vector<const model::Type*> partsOf(const model::Type& type, const model::Lookup& lookup) {
  std::vector<const model::Type*> parts{&type};
  if (const model::Struct* const record = lookup.findStruct(type.name)) {
    for (const model::Field& field : record->fields) parts.push_back(&field.type);
  }
  return parts;
}

bool isNumberList(const model::Type& type) {
  const bool list = type.shape == Shape::List || type.shape == Shape::Array;
  return (list && isNumber(type.element.front())) ||
         (type.shape == Shape::Matrix && type.columns == 1);
}

bool hasLists(const model::Type& type, const model::Lookup& lookup,
              std::initializer_list<std::string_view> names) {
  const model::Struct* const record = lookup.findStruct(type.name);
  return record != nullptr && std::all_of(names.begin(), names.end(), [&](std::string_view name) {
           return std::any_of(record->fields.begin(), record->fields.end(),
                              [&](const model::Field& field) {
                                return field.name == name && isNumberList(field.type);
                              });
         });
}

}  // namespace

std::optional<Meaning> meaningOf(std::string_view name) {
  for (const std::string_view space : kNamespaces) {
    if (name.starts_with(space)) return plainMeaning(name.substr(space.size()));
  }
  return plainMeaning(name);
}

bool carries(const model::Type& type, Payload payload, const model::Lookup& lookup) {
  const std::vector<const model::Type*> parts = partsOf(type, lookup);
  const auto count = [&](const auto& is) {
    return std::count_if(parts.begin(), parts.end(), [&](const auto* part) { return is(*part); });
  };
  const bool pose = count([](const auto& one) { return one.shape == Shape::Isometry; }) > 0;
  const bool twist = count([](const auto& one) { return isVector(one, 6); }) > 0 ||
                     count([](const auto& one) { return isVector(one, 3); }) >= 2;
  switch (payload) {
    case Payload::Any: return true;
    case Payload::JointState: return hasLists(type, lookup, {"position", "velocity", "effort"});
    case Payload::Joints: return count(isNumberList) > 0 && !twist;
    case Payload::Pose: return pose;
    case Payload::Twist: return twist;
    case Payload::CartesianState: return pose && twist;
    case Payload::State: return count([](const auto& one) { return one.shape == Shape::Enum; }) > 0;
    case Payload::Text: return type.shape == Shape::Text;
    case Payload::Flag: return type.shape == Shape::Scalar && type.scalar == model::Scalar::Bool;
    case Payload::Message:
      return count([](const auto& one) { return one.shape == Shape::Text; }) > 0;
  }
  return false;
}

const char* describe(Payload payload) {
  switch (payload) {
    case Payload::Any: return "anything";
    case Payload::JointState: return "a joint state (lists 'position', 'velocity' and 'effort')";
    case Payload::Joints: return "a joint vector (a list of numbers, or a type that has one)";
    case Payload::Pose: return "a pose (an Eigen::Isometry3d, or a type that has one)";
    case Payload::Twist: return "a twist or wrench (a vector of 6 numbers, or two of 3)";
    case Payload::CartesianState: return "a pose and a twist (an Eigen::Isometry3d and 6 numbers)";
    case Payload::State: return "an operating state (an enum, or a type that has one)";
    case Payload::Text: return "a string";
    case Payload::Flag: return "a bool";
    case Payload::Message: return "a message (a string, or a type that has one)";
  }
  return "";
}

}  // namespace crtk

namespace {

using crtk::Payload;
using crtk::Role;

class Conformity {
 public:
  Conformity(const model::Lookup& lookup, model::Diagnostics& findings)
      : lookup_(lookup), findings_(findings) {}

  void check(const model::Command& command) {
    const std::string subject = "command '" + command.name + "'";
    const auto meaning = meaningOf(subject, command.name, command.source);
    if (!meaning) return;
    const bool read = command.kind == model::CommandKind::Read;
    const bool isConst = read || command.kind == model::CommandKind::QualifiedRead;
    if (meaning->role == Role::Query && !read) {
      model::Diagnostic& finding =
          addError(findings_, command.source, "crtk-query",
                   subject + " is a CRTK query but not a const method without parameters",
                   "declare it as 'virtual ... " + command.name + "() const = 0'");
      if (!isConst && command.parameters.empty()) {
        finding.fixes = {{command.signature, model::Fix::Place::After, " const"}};
      }
    } else if (meaning->role == Role::Motion && (isConst || command.parameters.empty())) {
      addError(
          findings_, command.source, "crtk-motion",
          subject + " is a CRTK command but " + (isConst ? "const, thus a read" : "takes no goal"),
          "declare it as 'virtual void " + command.name + "(const Goal& goal) = 0'");
    } else if (meaning->role == Role::Query) {
      checkPayload(subject, *command.result, meaning->payload, command.source);
    } else if (meaning->role == Role::Motion) {
      const model::Parameter& goal = command.parameters.front();
      checkPayload(subject, goal.type, meaning->payload, goal.source);
    }
  }

  void check(const model::Event& event) {
    const std::string subject = "event '" + event.name + "'";
    const auto meaning = meaningOf(subject, event.name, event.source);
    if (!meaning || meaning->payload == Payload::Any) return;
    if (event.payload.empty()) {
      addError(findings_, event.source, "crtk-payload",
               subject + " carries nothing; CRTK says " + describe(meaning->payload),
               "declare it as suture::EventOf<T> with such a T");
    } else {
      checkPayload(subject, event.payload.front(), meaning->payload, event.source);
    }
  }

 private:
  std::optional<crtk::Meaning> meaningOf(const std::string& subject, const std::string& name,
                                         const model::Source& source) {
    const auto meaning = crtk::meaningOf(name);
    if (!meaning) {
      addError(
          findings_, source, "crtk-name",
          subject + " of a crtk() contract has a name that CRTK does not know",
          "a name is level_space, such as measured_cp, servo_jp or move_cr; what CRTK does not "
          "know belongs into a contract of its own");
    }
    return meaning;
  }

  void checkPayload(const std::string& subject, const model::Type& type, Payload payload,
                    const model::Source& source) {
    if (crtk::carries(type, payload, lookup_)) return;
    addError(findings_, source, "crtk-payload",
             subject + " carries '" + type.spelling + "'; CRTK says " + crtk::describe(payload),
             "give it such a type, or another name");
  }

  const model::Lookup& lookup_;
  model::Diagnostics& findings_;
};

}  // namespace

void checkCrtk(const model::Header& header, const model::Lookup& lookup,
               model::Diagnostics& findings) {
  Conformity conformity(lookup, findings);
  for (const model::Interface& interface : header.interfaces) {
    if (!interface.crtk) continue;
    for (const model::Command& command : interface.commands) conformity.check(command);
    for (const model::Event& event : interface.events) conformity.check(event);
  }
}

}  // namespace suture::compiler::check
