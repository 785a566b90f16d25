// These run the emitters on a hand-made model.

#include "compiler/emit/emit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/emit/cpp/component_library.h"
#include "tests/unit/emit/sample_model.h"

namespace suture::compiler::emit {
namespace {

class EmitTest : public testing::Test {
 protected:
  /// Returns the generated text of `path`.
  std::string text(const std::string& path) {
    model::Diagnostics none;
    const lock::Locks locks = lock::read(lock::update(model_, {}).files, none);
    for (const Artefact& artefact : emit(model_, locks)) {
      if (artefact.path == path) return artefact.text;
    }
    return "";
  }

  model::Interface& arm() { return sample::armHeader(model_).interfaces[0]; }

  model::Model model_ = sample::robots();
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(EmitTest, EachHeaderGivesOrderedOutputs) {
  std::vector<std::string> expected;
  for (const char* const stem : {"robots/arm", "robots/gripper", "robots/simulated_arm"}) {
    for (const Output& output : outputs()) {
      expected.push_back(std::string(stem) + "." + output.suffix);
    }
  }
  std::vector<std::string> paths;
  for (const Artefact& artefact : emit(model_, {})) paths.push_back(artefact.path);
  EXPECT_EQ(paths, expected);
}

TEST_F(EmitTest, ABigHeadersSourcesShareDeclarations) {
  const std::string path = sample::armHeader(model_).path;
  std::string all;
  std::set<std::string> paths;
  for (const Artefact& artefact : emit(model_, {}, {{path, 3}})) {
    if (!artefact.path.starts_with("robots/arm.")) continue;
    paths.insert(artefact.path);
    if (artefact.path.ends_with(".cpp")) all += artefact.text;
  }
  for (const char* const kind : {"suture", "wire"}) {
    for (const char* const number : {"", ".2", ".3"}) {
      EXPECT_TRUE(paths.contains(std::string("robots/arm.") + kind + number + ".cpp")) << number;
    }
  }
  EXPECT_TRUE(paths.contains("robots/arm.wire.capnp"));
  EXPECT_TRUE(paths.contains("robots/arm.wire.3.capnp"));
  const std::string definition = "bool store(const Everything& value, EverythingSlot& slot) {";
  EXPECT_EQ(all.find(definition), all.rfind(definition));
  EXPECT_NE(all.find(definition), std::string::npos);
  EXPECT_EQ(paths.size(), outputs().size() + 4 + 3);
}

TEST_F(EmitTest, EqualModelsGiveEqualBytes) {
  const auto once = emit(model_, {});
  EXPECT_EQ(emit(sample::robots(), {}), once);
}

TEST_F(EmitTest, ADerivedContractKeepsItsBasesOrder) {
  model::Diagnostics none;
  const lock::Locks locks = lock::read(lock::update(model_, {}).files, none);
  const auto before = emit(model_, locks);
  for (model::Header& header : model_.headers) {
    for (model::Interface& interface : header.interfaces) {
      std::reverse(interface.commands.begin(), interface.commands.end());
      std::reverse(interface.events.begin(), interface.events.end());
    }
  }
  EXPECT_EQ(emit(model_, locks), before);
}

TEST_F(EmitTest, ADerivedContractHoldsItsAdditions) {
  const std::string source = text("robots/gripper.wire.cpp");
  EXPECT_FALSE(contains(source, "ServoCpParams"));
  EXPECT_TRUE(contains(source,
                       "suture::interfaceInfo<robots::Arm>().codec().commands, "
                       "kGripperCommandCodecs"));
  EXPECT_TRUE(contains(text("robots/gripper.suture.h"),
                       "class Required<robots::Gripper> : public Required<robots::Arm> {"));
}

TEST_F(EmitTest, AnEmptyDerivedContractUsesItsBase) {
  for (model::Header& header : model_.headers) {
    for (model::Interface& interface : header.interfaces) {
      if (interface.base.empty()) continue;
      std::erase_if(interface.commands, [](const auto& one) { return one.inheritedFrom.empty(); });
      std::erase_if(interface.events, [](const auto& one) { return one.inheritedFrom.empty(); });
    }
  }
  const std::string source = text("robots/gripper.suture.cpp");
  EXPECT_TRUE(contains(source, ".commands = interfaceInfo<robots::Arm>().commands,"));
  EXPECT_FALSE(contains(source, "Provided<robots::Gripper>::execute"));
}

TEST_F(EmitTest, SourcePositionsDoNotShow) {
  const auto before = emit(model_, {});
  for (model::Field& field : sample::armHeader(model_).structs[0].fields) field.source.line = 77;
  arm().source.line = 99;
  EXPECT_EQ(emit(model_, {}), before);
}

TEST_F(EmitTest, DocumentationIsCarriedOver) {
  arm().commands[0].doc.text = "Powers the arm.";
  EXPECT_TRUE(contains(text("robots/arm.suture.h"), "  /// Powers the arm.\n"));
  EXPECT_TRUE(contains(text("robots/arm.suture.json"), "\"doc\": \"Powers the arm.\""));
}

TEST_F(EmitTest, NamedBoundsIncludeLimits) {
  const auto includesLimits = [this] {
    return contains(text("robots/arm.suture.cpp"), "#include <limits>\n");
  };
  arm().doc.text = "Admits std::numeric_limits<double>::infinity() nowhere.";
  EXPECT_FALSE(includesLimits());
  for (model::Command& command : arm().commands) {
    for (model::Parameter& one : command.parameters) {
      if (one.type.shape == model::Type::Shape::Scalar) {
        one.range = {0, std::numeric_limits<double>::infinity()};
      }
    }
  }
  EXPECT_TRUE(includesLimits());
}

TEST_F(EmitTest, AnEmptyContractIsWellFormed) {
  arm().commands.clear();
  arm().events.clear();
  const std::string source = text("robots/arm.suture.cpp");
  EXPECT_TRUE(contains(source, ".commands = {},"));
  EXPECT_TRUE(contains(source, ".events = {},"));
  EXPECT_FALSE(contains(text("robots/arm.suture.h"), "struct Events"));
}

TEST_F(EmitTest, AnUnboundedTypesSlotOwnsMemory) {
  EXPECT_TRUE(contains(text("robots/simulated_arm.suture.h"), "  suture::OpenText "));
}

TEST_F(EmitTest, NumbersFollowTheLock) {
  model::Diagnostics none;
  const lock::Locks locks = lock::read(lock::update(model_, {}).files, none);
  const auto before = emit(model_, locks);
  std::reverse(arm().commands.begin(), arm().commands.end());
  std::reverse(arm().events.begin(), arm().events.end());
  EXPECT_EQ(emit(model_, locks), before) << "two builds of one lock must number alike";
}

TEST_F(EmitTest, RemovedEnumeratorsAreRefusedByName) {
  model::Diagnostics none;
  const lock::Locks before = lock::read(lock::update(model_, {}).files, none);
  sample::armHeader(model_).enums[0].enumerators.erase(
      sample::armHeader(model_).enums[0].enumerators.begin() + 1);
  std::vector<Artefact> texts = lock::update(model_, before).files;
  const std::string source = emit(model_, lock::read(texts, none))[2].text;
  EXPECT_TRUE(contains(source, "    case wire::Mode::REMOVED1: break;\n"));
}

TEST_F(EmitTest, HashKnowsTheWireAndNothingElse) {
  const auto hash = [this] {
    const auto json = nlohmann::json::parse(text("robots/arm.suture.json"));
    return json["interfaces"][0]["hash"].get<std::string>();
  };
  const std::string before = hash();
  EXPECT_EQ(before.size(), 32u);
  arm().doc.text = "Other words.";
  arm().commands[0].queue = 1;
  EXPECT_EQ(hash(), before);
  model_.headers[1].structs[0].fields[0].unit = "mm";  // in a foreign header that it reaches
  EXPECT_NE(hash(), before);
}

TEST_F(EmitTest, DescriptionSaysWhatTheTypesAre) {
  const auto json = nlohmann::json::parse(text("robots/arm.suture.json"));
  const auto& fields = json["structs"][0]["fields"];
  EXPECT_EQ(fields[3]["unit"], "m/s");
  EXPECT_EQ(fields[3]["range"][0], -0.5);
  EXPECT_EQ(fields[3]["default"], 0.25);
  EXPECT_EQ(fields[10]["type"]["element"]["length"], 2);
  EXPECT_EQ(json["interfaces"][0]["commands"][1]["ttl"], 0.02);
  EXPECT_EQ(json["interfaces"][0]["events"][0]["latched"], true);
}

TEST_F(EmitTest, APageLinksToOtherTargets) {
  model::Header& contract = sample::armHeader(model_);
  contract.own = false;
  for (model::Header& one : model_.headers) one.file = "/project/" + one.path;
  const std::string link = "[`Arm`](arm.suture.md#arm-contract)";
  EXPECT_TRUE(contains(text("robots/simulated_arm.suture.md"), link));
  contract.file = "/usr/include/" + contract.path;
  EXPECT_FALSE(contains(text("robots/simulated_arm.suture.md"), link));
}

TEST_F(EmitTest, NumbersAreReadWithinTheirRange) {
  const auto add = [](model::Struct& parameters, const std::string& name, model::Type type) {
    parameters.fields.push_back(sample::field(name, std::move(type)));
    parameters.fields.back().range = {{0, 1}};
  };
  model::Type matrix, map;
  matrix.shape = model::Type::Shape::AnyMatrix;
  map.shape = model::Type::Shape::Map;
  map.element = {sample::text(4), sample::number()};
  map.capacity = 4;
  for (model::Header& header : model_.headers) {
    for (model::Struct& parameters : header.structs) {
      if (parameters.name != "robots::ArmParameters") continue;
      add(parameters, "gains", matrix);
      add(parameters, "shares", map);
      add(parameters, "weights", sample::listOf(sample::number(), 4));
    }
  }
  const std::string source = text("robots/simulated_arm.suture.cpp");
  for (const char* const name : {"gains", "shares", "weights"}) {
    const std::string field = std::string("(\"") + name + "\", value." + name + ", 0, 1)";
    EXPECT_TRUE(contains(source, field)) << source;
  }
}

TEST_F(EmitTest, OneSourceReadsAForeignType) {
  sample::armHeader(model_).own = false;  // with the enum that parameters have a value of
  model::Header other = model_.headers.back();
  other.path = "robots/third_arm.h";
  other.components[0].name = "robots::ThirdArm";
  other.components[0].parameters = other.structs[0].name = "robots::ThirdParameters";
  model_.headers.push_back(other);
  const std::string reader = "void fromJson(const suture::JsonReader& in, Mode& value)";
  const std::string first = text("robots/simulated_arm.suture.cpp"),
                    second = text("robots/third_arm.suture.cpp");
  EXPECT_TRUE(contains(first, "[[gnu::weak]] " + reader + " {")) << first;
  EXPECT_TRUE(contains(second, "// Defined in robots/simulated_arm.suture.cpp.")) << second;
  EXPECT_TRUE(contains(second, reader + ";"));
  EXPECT_FALSE(contains(second, reader + " {")) << "a unity build would have it twice";
}

TEST_F(EmitTest, TheEntryPointListsAllComponents) {
  model::Header other = model_.headers.back();
  other.path = "robots/other_arm.h";
  other.components[0].name = "robots::OtherArm";
  model::Header foreign = other;
  foreign.own = false;
  foreign.components[0].name = "robots::ForeignArm";
  model_.headers.push_back(other);
  model_.headers.push_back(foreign);
  const Artefact file = emitComponentLibrary(model_, "robots", "robots.components.cpp");
  EXPECT_EQ(file.path, "robots.components.cpp");
  EXPECT_EQ(file.text, R"(// Written by suturec for target robots. Do not edit.
#include <suture/component/factory/component_library.h>

#include "robots/simulated_arm.suture.h"
#include "robots/other_arm.suture.h"

/// A deployment that names this library calls it.
extern "C" const suture::ComponentLibrary* suture_components() {
  static const suture::ComponentClass kClasses[] = {
      suture::componentClass<robots::SimulatedArm>(),
      suture::componentClass<robots::OtherArm>(),
  };
  static const suture::ComponentLibrary kLibrary{.version = suture::kVersion, .classes = kClasses};
  return &kLibrary;
}
)");
}

TEST_F(EmitTest, AnEntryPointMayBeEmpty) {
  const std::string text = emitComponentLibrary(model::Model{}, "none", "none.cpp").text;
  EXPECT_FALSE(contains(text, "kClasses"));
  EXPECT_TRUE(contains(text, ".classes = {}}"));
}

TEST_F(EmitTest, RequiredInterfacesMayBeOptional) {
  model::Component& component = model_.headers.back().components[0];
  const auto required = [](const std::string& name, bool optional) {
    return model::Port{.member = name,
                       .name = name,
                       .interface = "robots::Arm",
                       .optional = optional,
                       .source = {}};
  };
  component.ports = {required("First", true), required("Second", false), required("Third", true)};
  EXPECT_TRUE(contains(text("robots/simulated_arm.suture.cpp"),
                       "            std::unique_ptr<Component> component(new "
                       "robots::SimulatedArm(values));\n"
                       "            makeOptional(*component, {\"First\", \"Third\"});\n"
                       "            return component;\n"));
}

TEST_F(EmitTest, ParametersMayBeTakenAsAnRvalue) {
  model_.headers.back().components[0].movesParameters = true;
  EXPECT_TRUE(contains(text("robots/simulated_arm.suture.cpp"),
                       "(new robots::SimulatedArm(std::move(values)));"));
}

TEST_F(EmitTest, RequiredInterfacesMayLimitAges) {
  model::Component& component = model_.headers.back().components[0];
  component.ports = {model::Port{.member = "slave_",
                                 .name = "Slave",
                                 .interface = "robots::Arm",
                                 .maxAgeNanoseconds = 10'000'000,
                                 .source = {}}};
  EXPECT_TRUE(contains(text("robots/simulated_arm.suture.cpp"),
                       "            limitAge(*component, \"Slave\", Duration(10'000'000));\n"
                       "            return component;\n"));
}

}  // namespace
}  // namespace suture::compiler::emit
