#pragma once
// This lists what the doctor checked, in order: after the first failure it does not try the rest.

#include <suture/base/errors.h>
#include "cli/values/json.h"

#include <string>
#include <vector>

namespace suture::cli {

/// A Step is one thing that was checked.
struct Step {
  enum class State { Ok, Skipped, Failed, NotTried };

  std::string name;
  State state = State::NotTried;
  std::string found, remedy;
};

/// Holds the steps on the way to one thing.
class Checklist {
 public:
  explicit Checklist(std::string subject) : subject_(std::move(subject)) {}

  /// `look` returns what it found, or throws SetupError, whose text ends with what to do; if it
  /// does not, `remedy` says that.
  template <class Look>
  void step(const char* name, const std::string& remedy, Look look) {
    add(name, remedy, Step::State::Ok, look);
  }
  /// Skips what need not be; `look` returns why.
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
