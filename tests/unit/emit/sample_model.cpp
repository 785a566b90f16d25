#include "tests/unit/emit/sample_model.h"

namespace suture::compiler::sample {

using model::CommandKind;
using model::Scalar;
using model::Type;

namespace {

model::Header geometryHeader() {
  model::Header header;
  header.path = "robots/geometry.h";
  header.cxxNamespace = "robots";
  header.own = false;
  header.structs = {
      structure("robots::PoseStamped", {field("pose", isometry()), field("stamp", steadyTime()),
                                        field("valid", scalar(Scalar::Bool))})};
  header.structs[0].fields[0].isPreset = true;
  header.structs[0].fields[2].defaultJson = "false";
  header.structs[0].doc.text = "A pose with its time.";
  return header;
}

model::Enum mode() {
  model::Enum result =
      enumerated("robots::Mode", {{"Disabled", -1}, {"HoldStill", 4}, {"Servo", 2}});
  result.underlying = Scalar::Int8;
  result.underlyingType = "std::int8_t";
  result.doc.text = "What the arm does.";
  result.enumerators[1].doc.text = "Brakes off, set-point frozen.";
  return result;
}

model::Struct everything() {
  std::vector<model::Field> fields = {
      field("on", scalar(Scalar::Bool)),
      field("tiny", scalar(Scalar::Int8)),
      field("count", scalar(Scalar::UInt64)),
      field("speed", number(), "m/s"),
      field("ratio", scalar(Scalar::Float32)),
      field("mode", enumeration("robots::Mode")),
      field("label", text(16)),
      field("bytes", listOf(scalar(Scalar::UInt8), 32)),
      field("flags", listOf(scalar(Scalar::Bool), 4)),
      field("names", listOf(text(8), 3)),
      field("pairs", listOf(arrayOf(number(), 2), 5)),
      field("modes", arrayOf(enumeration("robots::Mode"), 2)),
      field("goal", record("robots::PoseStamped")),
      field("track", listOf(record("robots::PoseStamped"), 2)),
      field("point", matrix(3, 1), "m"),
      field("plane", matrix(3, 1, Scalar::Float32)),
      field("inertia", matrix(3, 3)),
      field("jacobian", matrix(6, 7)),
      field("attitude", quaternion()),
      field("period", milliseconds()),
      field("when", steadyTime()),
  };
  fields[0].defaultJson = "false";
  fields[1].defaultJson = fields[2].defaultJson = "0";
  fields[4].defaultJson = "0.0";
  fields[3].range = {{-0.5, 2}};
  fields[3].defaultJson = "0.25";
  fields[3].doc.text = "Along the path.";
  fields[5].defaultJson = "\"Servo\"";
  for (model::Field& one : fields) {
    const Type::Shape shape = one.type.shape;
    one.isPreset = shape == Type::Shape::Matrix || shape == Type::Shape::Quaternion;
    if (shape == Type::Shape::Duration) one.defaultJson = "0.0";
  }
  model::Struct result = structure("robots::Everything", std::move(fields));
  result.doc.text = "Every kind of member.\n\nTwo paragraphs.";
  return result;
}

model::Struct parameters() {
  model::Struct result =
      structure("robots::ArmParameters", {field("rate", number(), "Hz"), field("name", text(0)),
                                          field("start", enumeration("robots::Mode"))});
  result.fields[0].range = {{1, 4000}};
  result.fields[0].defaultJson = "1000.0";
  result.fields[1].type.capacity.reset();
  result.fields[2].defaultJson = "\"Disabled\"";
  result.doc.text = "How a simulated arm behaves.";
  return result;
}

model::Interface arm() {
  model::Interface result;
  result.name = "robots::Arm";
  result.wireName = "Arm";
  result.doc.text = "A robot arm.";

  model::Command servo = write("servo_cp", "goal", record("robots::PoseStamped"));
  servo.latest = true;
  servo.ttlNanoseconds = 20'000'000;
  servo.doc.text = "Follow the goal.";
  model::Command solve = command("inverse_kinematics", CommandKind::QualifiedRead);
  solve.parameters = servo.parameters;
  solve.parameters[0].name = solve.parameters[0].wireName = "x";
  solve.parameters.push_back(write("", "tolerance", number()).parameters[0]);
  solve.parameters[1].byReference = false;
  solve.parameters[1].range = {{0, 1}};
  solve.result = record("robots::Everything");
  solve.resultByReference = true;
  model::Command all = read("everything", record("robots::Everything"));
  all.resultByReference = true;
  result.commands = {command("enable", CommandKind::Void),
                     servo,
                     write("set_speed", "speed", number()),
                     read("measured_cp", record("robots::PoseStamped")),
                     read("mode", enumeration("robots::Mode")),
                     all,
                     solve};
  result.commands[0].queue = 4;
  result.commands[2].parameters[0].byReference = false;
  result.commands[2].parameters[0].unit = "m/s";

  model::Command grasp = command("grasp", CommandKind::WriteReturn);
  grasp.parameters = {write("", "width", number()).parameters[0],
                      write("", "mode", enumeration("robots::Mode")).parameters[0]};
  grasp.parameters[0].byReference = grasp.parameters[1].byReference = false;
  grasp.result = scalar(Scalar::Bool);
  grasp.deadlineNanoseconds = 50'000'000;
  grasp.queue = 2;
  grasp.doc.text = "Closes the gripper; answers whether it holds something.";
  model::Command token = command("next_token", CommandKind::VoidReturn);
  token.result = scalar(Scalar::UInt32);
  token.lifecycle.since = 1;
  model::Command park = command("park", CommandKind::Void);
  park.optional = park.direct = true;
  park.lifecycle.deprecated = "use enable";
  model::Command load = read("load", number());
  load.optional = true;
  for (const model::Command& one : {grasp, token, park, load}) result.commands.push_back(one);

  model::Event changed = event("mode_changed", {enumeration("robots::Mode")});
  changed.latched = true;
  changed.queue = 8;
  model::Event moved =
      event("moved", {record("robots::PoseStamped"), number(), enumeration("robots::Mode")});
  moved.latched = true;
  moved.doc.text = "Where, how fast and why.";
  result.events = {changed, event("stopped"), event("arrived", {record("robots::PoseStamped")}),
                   moved};
  return result;
}

/// Derives from Arm, whose commands and events come first.
model::Interface gripper() {
  model::Interface result = arm();
  for (model::Command& command : result.commands) command.inheritedFrom = result.name;
  for (model::Event& event : result.events) event.inheritedFrom = result.name;
  result.base = result.name;
  result.name = "robots::Gripper";
  result.wireName = "Gripper";
  result.version = 2;
  result.lifecycle.since = 2;
  result.doc.text = "An arm with a gripper.";

  model::Command open = write("open", "width", number());
  open.parameters[0].byReference = false;
  open.parameters[0].unit = "m";
  model::Command opening = read("opening", number());
  opening.lifecycle.since = 2;
  model::Command fits = write("fits", "width", number());
  fits.parameters[0].byReference = false;
  fits.kind = CommandKind::QualifiedRead;
  fits.result = scalar(Scalar::Bool);
  fits.concurrent = true;
  for (const model::Command& one : {open, opening, fits}) result.commands.push_back(one);
  model::Event gripped = event("gripped", {number(), scalar(Scalar::Bool)});
  gripped.member = "gripped";
  gripped.lifecycle.since = 2;
  result.events.push_back(gripped);
  return result;
}

model::Header contractHeader() {
  model::Header header;
  header.path = "robots/arm.h";
  header.cxxNamespace = "robots";
  header.imports = {"robots/geometry.h"};
  header.enums = {mode()};
  header.structs = {everything()};
  header.interfaces = {arm()};
  return header;
}

/// Returns an interface with members that are called as arguments of the annotations are.
model::Interface names() {
  model::Interface result;
  result.name = "robots::Names";
  result.wireName = "Names";
  result.doc.text = "Members that are called as arguments of the annotations are.";
  model::Command queue = write("queue", "name", scalar(Scalar::Int32));
  queue.queue = 4;
  model::Command name = command("name", CommandKind::WriteReturn);
  name.wireName = "title";
  name.parameters = {write("", "range", number()).parameters[0],
                     write("", "slot", number()).parameters[0],
                     write("", "store", number()).parameters[0]};
  name.result = scalar(Scalar::Bool);
  model::Event latched = event("latched", {number()});
  latched.latched = true;
  model::Command range = read("range", number());
  range.resultRange = {{0, 1}};
  result.commands = {queue, name, range};
  result.events = {latched};
  return result;
}

model::Header gripperHeader() {
  model::Header header;
  header.path = "robots/gripper.h";
  header.cxxNamespace = "robots";
  header.imports = {"robots/arm.h", "robots/geometry.h"};
  header.interfaces = {gripper(), names()};
  return header;
}

model::Header componentHeader() {
  model::Header header;
  header.path = "robots/simulated_arm.h";
  header.cxxNamespace = "robots";
  header.imports = {"robots/arm.h"};
  header.structs = {parameters()};
  model::Component component;
  component.name = "robots::SimulatedArm";
  component.doc.text = "The arm is where it was last sent to.";
  component.parameters = "robots::ArmParameters";
  component.ports = {{.member = "arm_",
                      .name = "Arm",
                      .interface = "robots::Arm",
                      .provided = true,
                      .source = {}}};
  header.components = {component};
  return header;
}

}  // namespace

model::Model robots() {
  return {{contractHeader(), geometryHeader(), gripperHeader(), componentHeader()}};
}

model::Model allOwn(model::Model model) {
  for (model::Header& header : model.headers) header.own = true;
  return model;
}

model::Header& armHeader(model::Model& model) { return model.headers.front(); }

}  // namespace suture::compiler::sample
