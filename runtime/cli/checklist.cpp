#include "cli/checklist.h"
#include "cli/text/screen.h"

#include <cctype>

namespace suture::cli {
namespace {

const char* stateName(Step::State state) {
  switch (state) {
    case Step::State::Ok: return "ok";
    case Step::State::Skipped: return "skipped";
    case Step::State::Failed: return "failed";
    case Step::State::NotTried: return "not tried";
  }
  return "";
}

/// Returns where the first sentence ends; after it an error says what to do.
std::size_t endOfSentence(const std::string& text) {
  for (std::size_t at = text.find(". "); at != std::string::npos; at = text.find(". ", at + 1)) {
    const auto next = static_cast<unsigned char>(text[at + 2]);
    if (std::isupper(next) != 0 || next == '`') return at;
  }
  return std::string::npos;
}

}  // namespace

void Checklist::fail(Step& step, const std::string& text, const std::string& remedy) {
  const std::size_t end = endOfSentence(text);
  step.state = Step::State::Failed;
  step.found = text.substr(0, end);
  step.remedy = end == std::string::npos ? remedy : text.substr(end + 2);
  good_ = false;
}

std::string Checklist::text() const {
  std::string text = subject_ + "\n";
  std::vector<std::vector<std::string>> rows;
  for (const Step& step : steps_) {
    rows.push_back({step.name, stateName(step.state), step.found});
    if (!step.remedy.empty()) rows.push_back({"", "", step.remedy});
  }
  return plain(text + columns(rows, 2));
}

Json Checklist::json() const {
  Json steps = Json::array();
  for (const Step& step : steps_) {
    Json one{{"step", step.name}, {"state", stateName(step.state)}};
    if (!step.found.empty()) one["found"] = step.found;
    if (!step.remedy.empty()) one["remedy"] = step.remedy;
    steps.push_back(std::move(one));
  }
  return {{"subject", subject_}, {"good", good_}, {"steps", std::move(steps)}};
}

}  // namespace suture::cli
