#pragma once
// This is a device whose contract has no bounds, and its client.

#include <suture/component/device.h>

#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/ends/gate.h"
#include "shapes/open.suture.h"

namespace conformance {

/// Any thread may send commands. Keeps what it is given.
class ArchiveDevice final : public suture::Device, public shapes::Archive {
 public:
  void put(const std::string& key, const shapes::Open& value) override {
    const std::lock_guard lock(mutex_);
    newest_.name = key;
    newest_.samples = value.samples;
    newest_.series = value.series;
    ++puts_;
  }
  void remark(const std::string& text) override {
    const std::lock_guard lock(mutex_);
    remark_ = text;
  }
  const shapes::Open& newest() const override { return newest_; }
  std::vector<std::string> find(const std::string& pattern) const override {
    return {pattern + " 1", pattern + " 2"};
  }
  shapes::Open replace(const shapes::Open& value) override {
    if (value.name == "throw") throw std::runtime_error("asked to");
    if (value.name == "slow") gate.pass();
    shapes::Open answer;
    answer.name = value.name + " replaced";
    answer.samples = value.samples;
    return answer;
  }

  int puts() const {
    const std::lock_guard lock(mutex_);
    return puts_;
  }
  std::string remark() const {
    const std::lock_guard lock(mutex_);
    return remark_;
  }
  auto& emit() { return archive_.emit(); }

  Gate gate;

 private:
  mutable std::mutex mutex_;
  shapes::Open newest_;
  std::string remark_;
  int puts_ = 0;
  suture::Provided<shapes::Archive> archive_{*this, "Archive", *this};
};

/// Writes down the events that reach it.
class Reader final : public suture::Device {
 public:
  Reader() {
    archive.on().renamed([this](const std::string& name) { names.push_back(name); });
    archive.on().grown([this](const std::string& what, const shapes::Root& root) {
      grown.push_back(what + " " + std::to_string(root.children.size()));
    });
    archive.on().changed([this](const shapes::Open& value) { changed = value.samples; });
  }

  suture::Required<shapes::Archive> archive{*this, "Archive"};
  std::vector<std::string> names, grown;
  std::vector<double> changed;
};

}  // namespace conformance
