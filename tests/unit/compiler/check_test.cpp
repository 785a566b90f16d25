// These test the rules on declarations: names, enums, numbers, recursion.

#include <gtest/gtest.h>

#include <limits>

#include "compiler/check/units.h"
#include "samples.h"

namespace suture::compiler::check::samples {
namespace {

using Slugs = std::vector<std::string>;

model::Enum enumOf(const std::vector<std::pair<std::string, std::int64_t>>& values) {
  model::Enum result;
  result.name = "demo::State";
  result.wireName = "State";
  for (const auto& [name, value] : values) {
    model::Enumerator enumerator;
    enumerator.name = enumerator.wireName = name;
    enumerator.value = value;
    result.enumerators.push_back(enumerator);
  }
  return result;
}

TEST(Check, AcceptsTheSample) { EXPECT_EQ(slugs(header()), Slugs{}); }

TEST(Check, LeavesForeignHeadersToTheirTarget) {
  model::Header foreign = header();
  foreign.own = false;
  foreign.structs[0].fields.push_back(field("x", number()));
  EXPECT_EQ(slugs(foreign), Slugs{});
}

TEST(Check, NamesThatMeetOnTheWire) {
  model::Header fields = header();
  fields.structs[0].fields.push_back(field("x", number()));
  EXPECT_EQ(slugs(fields), Slugs{"wire-name-clash"});

  model::Header commands = header();
  commands.interfaces[0].commands.push_back(write("move_", number()));
  EXPECT_EQ(slugs(commands), Slugs{"wire-name-clash"});

  model::Header types = header();
  types.interfaces[0].wireName = "Sample";
  EXPECT_EQ(slugs(types), Slugs{"wire-name-clash"});
}

TEST(Check, NamespacesMustNotHideWhatIsNamed) {
  model::Header inner = header();
  inner.interfaces.clear();
  inner.components.clear();
  inner.structs[0].name = "lab::demo::Sample";
  inner.cxxNamespace = "lab::demo";
  EXPECT_EQ(slugs(inner), Slugs{});
  inner.structs[0].fields[0].type.spelling = "std::array<demo::Angle, 2>";
  EXPECT_EQ(slugs(inner), Slugs{"hidden-namespace"});
  inner.structs[0].fields[0].type.spelling = "lab::demo::Angle";
  EXPECT_EQ(slugs(inner), Slugs{});
  inner.cxxNamespace = "lab::suture::arm";
  EXPECT_EQ(slugs(inner), Slugs{"hidden-namespace"});
  inner.cxxNamespace = "rpc::arm";
  EXPECT_EQ(slugs(inner), Slugs{"hidden-namespace"});
}

TEST(Check, CommandsAndEventsHaveSeparateNames) {
  model::Header both = header();
  both.interfaces[0].events.push_back(event("move", number()));
  EXPECT_EQ(slugs(both), Slugs{});
}

TEST(Check, NamesThatCapnpRefuses) {
  for (const std::string name : {"", "Upper", "with_underscore", "9lives", "winkel\xc3\x84"}) {
    model::Header bad = header();
    bad.structs[0].fields[0].wireName = name;
    EXPECT_EQ(slugs(bad), Slugs{"wire-name"}) << name;
  }
  model::Header type = header();
  type.structs[0].wireName = "sample";
  EXPECT_EQ(slugs(type), Slugs{"wire-name"});
}

TEST(Check, NamesThatCapnpNests) {
  for (const std::string name : {"Reader", "Builder", "Pipeline"}) {
    model::Header bad = header();
    bad.structs[0].wireName = name;
    EXPECT_EQ(slugs(bad), Slugs{"reserved-name"}) << name;
  }
  model::Header client = header();
  client.interfaces[0].wireName = "Client";
  EXPECT_EQ(slugs(client), Slugs{"reserved-name"});
  model::Header data = header();
  data.structs[0].wireName = "Client";
  EXPECT_EQ(slugs(data), Slugs{});
}

TEST(Check, EnumeratorsThatBecomeMacros) {
  model::Header bad = header();
  bad.enums.push_back(enumOf({{"eof", 0}}));
  EXPECT_EQ(slugs(bad), Slugs{"macro-name"});
}

TEST(Check, ReportsEnumeratorsThatAreMacros) {
  model::Model model{{header()}};
  model.headers[0].enums.push_back(enumOf({{"debug", 0}, {"ok", 1}}));
  model.macros = {{"DEBUG", model::MacroOrigin::CommandLine}, {"OK", model::MacroOrigin::Header}};
  const model::Diagnostics findings = check(model);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].slug, "macro-name");
  EXPECT_NE(findings[0].message.find("'debug' becomes DEBUG"), std::string::npos);
}

TEST(Check, AnEnumWithoutDistinctValuesIsRefused) {
  model::Header bad = header();
  bad.enums = {enumOf({})};
  EXPECT_EQ(slugs(bad), Slugs{"empty-enum"});
  bad.enums = {enumOf({{"one", 1}, {"uno", 1}})};
  EXPECT_EQ(slugs(bad), Slugs{"duplicate-value"});
  bad.enums = {enumOf({{"low", -1}, {"high", 1}})};
  EXPECT_EQ(slugs(bad), Slugs{});
}

TEST(Check, FieldsThatNothingInitialisesAreWarnedOf) {
  model::Header bare = header();
  model::Field& field = bare.structs[0].fields[0];
  field.unset = model::Unset{"= 0", {}};
  const model::Diagnostics findings = check(model::Model{{bare}});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].slug, "no-initialiser");
  EXPECT_EQ(findings[0].severity, model::Diagnostic::Severity::Warning);
  EXPECT_EQ(findings[0].help, "initialise it where it is declared, with '= 0'");
  field.range = {1, 2};
  EXPECT_EQ(slugs(bare), Slugs{"default-range"});
  field.range.reset();
  bare.own = false;
  EXPECT_EQ(slugs(bare), Slugs{});
}

TEST(Check, UnknownUnitNamesTheNearest) {
  model::Header bad = header();
  bad.structs[0].fields[0].unit = "m/sec";
  const model::Diagnostics findings = check(model::Model{{bad}});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].slug, "unknown-unit");
  EXPECT_EQ(findings[0].help, "did you mean 'm/s'?");
}

TEST(Check, UnitsAreComposed) {
  for (const char* const unit :
       {"degC", "hPa", "mbar", "N.mm", "kg.m2/s", "W/m2", "uV/Hz", "s-1", "mol", "lx", "1/min"}) {
    EXPECT_TRUE(isKnownUnit(unit)) << unit;
  }
  EXPECT_EQ(nearestUnit("Nm"), "N.m");
  for (const char* const unit : {"Nm", "", "m/", ".m", "m//s", "m^2", "m22", "m1", "2", "-", "mdeg",
                                 "kmin", "m-", "meter"}) {
    EXPECT_FALSE(isKnownUnit(unit)) << unit;
  }
}

TEST(Check, UnitsAndRangesEverywhere) {
  model::Header bad = header();
  bad.interfaces[0].commands[0].parameters[0].unit = "furlong";
  bad.interfaces[0].commands[1].resultRange = {1, 0};
  bad.interfaces[0].events[0].limits = {{"", {{0, std::numeric_limits<double>::quiet_NaN()}}}};
  EXPECT_EQ(slugs(bad), (Slugs{"unknown-unit", "range-order", "range-order"}));
}

TEST(Check, RecursionEndsTheWalk) {
  model::Header bad = header();
  bad.structs[0].fields.push_back(field("children", list(named("demo::Sample"), 4)));
  EXPECT_EQ(slugs(bad), (Slugs{"recursive-capacity", "recursive-type"}));
}

TEST(Check, RecursionThroughAnotherType) {
  model::Header bad = header();
  model::Struct other;
  other.name = "demo::Other";
  other.wireName = "Other";
  other.fields.push_back(field("sample", named("demo::Sample")));
  bad.structs.push_back(other);
  bad.structs[0].fields.push_back(field("others", list(named("demo::Other"), 4)));
  EXPECT_EQ(slugs(bad), (Slugs{"recursive-capacity", "recursive-type"}));
}

/// Returns header() with a chain of structs of which each has two of the one before; `hold` makes
/// the type of such a member.
template <class Hold>
model::Header chain(unsigned levels, const Hold& hold) {
  model::Header result = header();
  for (unsigned i = 0; i < levels; ++i) {
    model::Struct link;
    link.name = "demo::N" + std::to_string(i);
    link.wireName = "N" + std::to_string(i);
    if (i > 0) {
      const model::Type before = named("demo::N" + std::to_string(i - 1));
      link.fields = {field("a", hold(before)), field("b", hold(before))};
    }
    result.structs.push_back(link);
  }
  model::Command last = read("last", named(result.structs.back().name));
  last.resultByReference = true;
  result.interfaces[0].commands.push_back(last);
  return result;
}

model::Type itself(model::Type type) { return type; }

// Two walks into each of 40 levels would take days.
TEST(Check, EachStructIsLookedIntoOnce) {
  EXPECT_EQ(slugs(chain(40, itself)), Slugs{});
  EXPECT_EQ(slugs(chain(40, [](const model::Type& type) { return list(type, 1); })).back(),
            "slot-size");
  model::Header open = chain(40, itself);
  open.structs[1].fields.push_back(field("name", text(std::nullopt)));
  EXPECT_EQ(slugs(open).back(), "unbounded-contract");
  model::Header deep = chain(64, itself);
  EXPECT_EQ(slugs(deep), (Slugs{"nesting", "nesting"}));
  model::Header back = chain(40, itself);
  model::Type top;
  top.shape = model::Type::Shape::Optional;
  top.element = {named("demo::N39")};
  back.structs[1].fields.push_back(field("back", top));
  EXPECT_EQ(slugs(back), Slugs{"recursive-type"});
}

TEST(Check, DevicesDoWithoutBounds) {
  model::Header open = header();
  open.structs[0].fields.push_back(field("name", text(std::nullopt)));
  open.structs[0].fields.push_back(field("children", list(named("demo::Sample"), std::nullopt)));
  open.components[0].base = model::ComponentBase::Device;
  EXPECT_EQ(slugs(open), Slugs{});
  open.components[0].base = model::ComponentBase::Task;
  EXPECT_EQ(slugs(open), Slugs{"unbounded-contract"});
}

TEST(Check, OneContractIsJudgedOnce) {
  model::Header open = header();
  open.structs[0].fields.push_back(field("name", text(std::nullopt)));
  open.components[0].ports.push_back(open.components[0].ports[0]);
  open.components[0].ports[1].name = "Other";
  EXPECT_EQ(slugs(open), Slugs{"unbounded-contract"});
}

TEST(Check, RecursionOutsideContractsIsFine) {
  model::Header fine = header();
  model::Struct tree;
  tree.name = "demo::Tree";
  tree.wireName = "Tree";
  tree.fields.push_back(field("children", list(named("demo::Tree"), std::nullopt)));
  fine.structs.push_back(tree);
  EXPECT_EQ(slugs(fine), Slugs{});
}

TEST(Check, OneFallbackIsEnough) {
  model::Header bad = header();
  bad.enums.push_back(enumOf({{"a", 0}, {"b", 1}}));
  bad.enums[0].enumerators[0].fallback = true;
  EXPECT_EQ(slugs(bad), Slugs{});
  bad.enums[0].enumerators[1].fallback = true;
  EXPECT_EQ(slugs(bad), Slugs{"second-fallback"});
}

TEST(Check, ATasksMapsAndMatricesNeedBounds) {
  using Shape = model::Type::Shape;
  model::Type map = list(number(), 3);
  map.shape = Shape::Map;
  map.element.push_back(text(4));
  model::Type matrix = number();
  matrix.shape = Shape::AnyMatrix;
  matrix.capacity = 3;
  matrix.columnCapacity = 3;
  model::Header contract = header();
  contract.structs[0].fields.push_back(field("map", map));
  contract.structs[0].fields.push_back(field("matrix", matrix));
  EXPECT_EQ(slugs(contract), Slugs{});
  contract.structs[0].fields[1].type.element[1].capacity.reset();
  EXPECT_EQ(slugs(contract), Slugs{"unbounded-contract"});
  contract.structs[0].fields[1].type = map;
  contract.structs[0].fields[2].type.columnCapacity.reset();
  EXPECT_EQ(slugs(contract), Slugs{"unbounded-contract"});
}

}  // namespace
}  // namespace suture::compiler::check::samples
