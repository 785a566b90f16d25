// This is the console's configuration: structs and enums in structs, and two that have one name.

#include "values/console.h"
#include "connected.h"
#include "labs/console.capnp.h"
#include "labs/console.suture.h"

namespace lab::console {

void toWire(const labarmConfigurationSlot&, wire::ArmConfiguration::Builder);
suture::Errc fromWire(wire::ArmConfiguration::Reader, labarmConfigurationSlot&, suture::Duration);
bool isValid(const labarmConfigurationSlot&, suture::FieldPath* = nullptr);
void toWire(const ConfigurationSlot&, wire::Configuration::Builder);
suture::Errc fromWire(wire::Configuration::Reader, ConfigurationSlot&, suture::Duration);
bool isValid(const ConfigurationSlot&, suture::FieldPath* = nullptr);
void toWire(const TeleoperationSlot&, wire::Teleoperation::Builder);
suture::Errc fromWire(wire::Teleoperation::Reader, TeleoperationSlot&, suture::Duration);
bool isValid(const TeleoperationSlot&, suture::FieldPath* = nullptr);

}  // namespace lab::console

namespace invented {

class ConsoleProvider final : public suture::EventTask, public lab::console::Console {
 public:
  void configure(const lab::console::Configuration& configuration) override {
    first_ = configuration.arms.at("PSM1");
    const auto& joint = first_.joints.at(0);
    require(port_.emit().limited(joint.type, joint).has_value(), "limited", "is not emitted");
  }
  const Arm& first() const override { return first_; }
  invented::Console::Pedal pressed() const override { return invented::Console::Pedal::Coag; }
  void run() override {}

 private:
  Arm first_;
  suture::Provided<lab::console::Console> port_{*this, "Port", *this};
};

void connectConsole(Random& random) {
  Joint heard;
  Connected<lab::console::Console, ConsoleProvider> console([&](auto& port) {
    port.on().limited([&](Joint::Type, const Joint& joint) { heard = joint; });
  });
  Console configuration;
  Arm& arm = configuration.arms["PSM1"];
  fill(arm, random);
  arm.joints.resize(7);
  arm.joints[0].limits = Joint::Limits();
  require(console.port().configure(configuration).has_value(), "configure", "is not sent");
  console.until([&] { return heard.limits.has_value(); }, "limited");
  require(heard.limits->upper == kInfinity, "limited", "brings another limit");
  const auto first = console.port().first.fresh().within(10s);
  require(first && same(*first, arm), "first", "is another one");
}

void checkConsole(Random& random) {
  namespace wire = lab::console::wire;
  checkType<Arm, lab::console::labarmConfigurationSlot, wire::ArmConfiguration>("arm", random);
  checkType<Teleoperation, lab::console::TeleoperationSlot, wire::Teleoperation>("pair", random);
  checkType<Console, lab::console::ConfigurationSlot, wire::Configuration>("console", random);

  Console console;
  Arm& arm = console.arms["PSM1"];
  arm.joints.resize(2);
  arm.joints[1].limits = Joint::Limits();
  checkRefused<lab::console::ConfigurationSlot>(console, "");
  arm.joints[1].limits->lower = 1;
  checkRefused<lab::console::ConfigurationSlot>(console, "arms[\"PSM1\"].joints[1].limits.lower");
  connectConsole(random);
}

}  // namespace invented
