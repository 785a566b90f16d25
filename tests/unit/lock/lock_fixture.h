#pragma once
// Tests of the lock share a model, its lock and what they look at of both.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "tests/unit/emit/sample_model.h"

namespace suture::compiler::lock {

using model::Diagnostic;
using model::Diagnostics;
using model::Scalar;

/// Returns the locks behind an update, also those of headers of other targets, which have written
/// theirs before.
inline Locks lockOf(const model::Model& model, const Locks& old = {}) {
  Diagnostics diagnostics;
  model::Model all = model;
  for (model::Header& header : all.headers) {
    header.own = header.own || !old.files.contains(lockPath(header.path));
  }
  std::vector<model::Artefact> texts = update(all, old).files;
  for (const auto& file : old.files) {
    const bool replaced = std::any_of(texts.begin(), texts.end(),
                                      [&](const auto& text) { return text.path == file.first; });
    if (!replaced) texts.push_back({file.first, file.second.text});
  }
  Locks locks = read(texts, diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << diagnostics.front().message;
  return locks;
}

inline const Lock& armLock(const Locks& locks) { return locks.files.at("robots/arm.capnp"); }

inline const Node& nodeOf(const Lock& lock, const std::string& name) {
  return *std::find_if(lock.nodes.begin(), lock.nodes.end(),
                       [&](const Node& node) { return node.name == name; });
}

inline std::vector<std::string> slugs(const Diagnostics& diagnostics) {
  std::vector<std::string> result;
  for (const Diagnostic& one : diagnostics) result.push_back(one.slug);
  return result;
}

using Slugs = std::vector<std::string>;

class LockTest : public testing::Test {
 protected:
  model::Struct& everything() { return sample::armHeader(model_).structs[0]; }
  model::Interface& arm() { return sample::armHeader(model_).interfaces[0]; }
  model::Field& field(const std::string& name) {
    auto& fields = everything().fields;
    return *std::find_if(fields.begin(), fields.end(),
                         [&](const model::Field& one) { return one.name == name; });
  }

  model::Model model_ = sample::robots();
  const Locks before_ = lockOf(model_);
};

}  // namespace suture::compiler::lock
