#pragma once
// What the doctor looked at, in order: after the first that fails the rest is not tried.

#include <suture/base/errors.h>
#include "cli/values/json.h"

#include <string>
#include <vector>

namespace suture::cli {

/// One thing that was looked at.
struct Step {
  enum class State { Ok, Skipped, Failed, NotTried };

  std::string name;
  State state = State::NotTried;
  std::string found, remedy;
};

/// The steps on the way to one thing.
class Checklist {
 public:
  explicit Checklist(std::string subject) : subject_(std::move(subject)) {}

  /// `look` tells what it found, or throws SetupError, whose text ends with what to do; where it
  /// does not, that is `remedy`.
  template <class Look>
  void step(const char* name, const std::string& remedy, Look look) {
    add(name, remedy, Step::State::Ok, look);
  }
  /// For what need not be: `look` tells why.
  template <class Look>
  void skip(const char* name, Look look) {
    add(name, "", Step::State::Skipped, look);
  }

  bool good() const { return good_; }
  std::string text() const;
  Json json() const;

 private:
  template <class Look>
  void add(const char* name, const std::string& remedy, Step::State state, Look look) {
    Step step{.name = name, .found = "", .remedy = ""};
    if (good_) {
      try {
        step.found = look();
        step.state = state;
      } catch (const SetupError& error) {
        fail(step, error.what(), remedy);
      }
    }
    steps_.push_back(std::move(step));
  }
  void fail(Step& step, const std::string& text, const std::string& remedy);

  const std::string subject_;
  std::vector<Step> steps_;
  bool good_ = true;
};

}  // namespace suture::cli
