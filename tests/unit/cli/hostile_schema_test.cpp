// Schemas with random bytes in them are refused, or used without harm. The sanitizers tell what
// harm is.

#include <capnp/dynamic.h>
#include <capnp/serialize.h>
#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/base/sanitizers.h>
#include <suture/codec/json/to_json.h>
#include "cli/contract/contract.h"
#include "cli/contract/from_json.h"
#include "cli/text/contract_text.h"

#include <algorithm>
#include <random>

#include "robots/arm.capnp.h"
#include "unit/cli/explanation.h"

namespace suture::cli {
namespace {

// ThreadSanitizer has little to find in one thread; AddressSanitizer makes it ten times as slow.
#if defined(SUTURE_THREAD_SANITIZER)
constexpr int kRounds = 200;
#elif defined(SUTURE_ADDRESS_SANITIZER)
constexpr int kRounds = 500;
#else
constexpr int kRounds = 2000;
#endif
constexpr unsigned kSeed = 20'26;

void spoil(kj::ArrayPtr<kj::byte> bytes, std::mt19937& random) {
  const unsigned changes = 1 + random() % 8;
  for (unsigned i = 0; i < changes; ++i) {
    bytes[random() % bytes.size()] = static_cast<kj::byte>(random());
  }
}

/// Converts in both directions, with memory of a struct that is none of these types.
void use(const Contract& contract) {
  capnp::MallocMessageBuilder any;
  auto filled = any.initRoot<robots::wire::Everything>();
  filled.setLabel("text");
  filled.setCount(7);
  filled.initGoal().initPose().setX(1);
  for (const Member& command : contract.commands()) {
    try {
      const auto results = any.getRoot<capnp::AnyPointer>().asReader().getAs<capnp::DynamicStruct>(
          command.method.getResultType());
      codec::toJson(results, codec::Labels::Units);
      capnp::MallocMessageBuilder arguments;
      const auto parameters =
          arguments.initRoot<capnp::DynamicStruct>(command.method.getParamType());
      fill(parameters, codec::toJson(parameters.asReader(), codec::Labels::Names), "");
    } catch (const SetupError&) {
      // A refusal in words is right.
    } catch (const kj::Exception&) {
      // The library may refuse it too.
    }
  }
}

TEST(HostileSchema, IsRefusedOrDoesNoHarm) {
  Explained explained;
  const auto original = capnp::messageToFlatArray(explained.message());
  std::mt19937 random(kSeed);
  int refused = 0, used = 0;
  for (int round = 0; round < kRounds; ++round) {
    auto words = kj::heapArray<capnp::word>(original.size());
    std::copy_n(original.asBytes().begin(), original.asBytes().size(), words.asBytes().begin());
    spoil(words.asBytes().slice(16, words.asBytes().size()), random);
    try {
      capnp::FlatArrayMessageReader message(words);
      const Contract contract("robot:Hand/Gripper", message.getRoot<wire::Explanation>());
      contractText(contract);
      use(contract);
      ++used;
    } catch (const SetupError&) {
      ++refused;
    } catch (const kj::Exception&) {
      ++refused;
    }
  }
  EXPECT_GT(used, kRounds / 20);
  EXPECT_GT(refused, kRounds / 20);
}

}  // namespace
}  // namespace suture::cli
