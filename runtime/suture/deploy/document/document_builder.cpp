#include <suture/deploy/document/document_builder.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace suture {
namespace {

// No value that anything reads is nested as deep, and what reads it may call itself.
constexpr std::size_t kDeepest = 64;

// Counts how far the parser has read.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, DocumentBuilder::Taken* taken) : at_(at), taken_(taken) {}

  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    if (taken_->characters > 0 && at_[-1] == '\n') ++taken_->line;
    ++at_;
    ++taken_->characters;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  DocumentBuilder::Taken* taken_;
};

int lineAt(std::string_view text, std::size_t offset) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

std::size_t columnAt(std::string_view text, std::size_t offset) {
  const std::size_t newline = text.substr(0, offset).rfind('\n');
  return newline == std::string_view::npos ? offset + 1 : offset - newline;
}

// Removes the prefix of nlohmann's text: the exception's name and, for a syntax error, the position
// of the token's end.
std::string withoutPrefix(const std::string& text) {
  const std::size_t column = text.find("column ");
  const std::size_t end = text.find(column == std::string::npos ? "] " : ": ",
                                    column == std::string::npos ? 0 : column);
  return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace

void DocumentBuilder::build() {
  const CountingIterator begin(text_.data(), &taken_);
  const CountingIterator end(text_.data() + text_.size(), &taken_);
  nlohmann::json::sax_parse(begin, end, this);
  if (!problems_.empty()) throw DocumentError(problems_);
}

bool DocumentBuilder::key(std::string& name) {
  Frame& frame = open_.back();
  frame.key = name;
  const std::string pointer = nextPointer();
  if (frame.container->contains(name)) {
    problems_.push_back(document_.name_ + ":" + std::to_string(lineNow()) + ": error: key '" +
                        name + "' was given before, on line " +
                        std::to_string(document_.lineOf(pointer)) + ". Keep one of the two");
  } else {
    document_.lines_[pointer] = lineNow();
  }
  return true;
}

// `position` counts the characters read, the last of which belongs to the offending token.
bool DocumentBuilder::parse_error(std::size_t position, const std::string&,
                                  const nlohmann::json::exception& error) {
  const std::size_t offset = std::min(position - std::min<std::size_t>(position, 1), text_.size());
  problems_.push_back(document_.name_ + ":" + std::to_string(lineAt(text_, offset)) + ":" +
                      std::to_string(columnAt(text_, offset)) +
                      ": error: this is not JSON: " + withoutPrefix(error.what()));
  return false;
}

nlohmann::json& DocumentBuilder::place(nlohmann::json value) {
  if (open_.empty()) return document_.value_ = std::move(value);
  Frame& frame = open_.back();
  if (frame.container->is_array()) {
    document_.lines_[nextPointer()] = lineNow();
    frame.container->push_back(std::move(value));
    return frame.container->back();
  }
  return (*frame.container)[frame.key] = std::move(value);
}

bool DocumentBuilder::add(nlohmann::json value) {
  place(std::move(value));
  return true;
}

bool DocumentBuilder::open(nlohmann::json container) {
  if (open_.size() == kDeepest) {
    problems_.push_back(document_.name_ + ":" + std::to_string(lineNow()) +
                        ": error: nested more than " + std::to_string(kDeepest) +
                        " deep; no value is, so remove what opens");
    return false;
  }
  const std::string pointer = nextPointer();
  if (pointer.empty()) document_.lines_[pointer] = lineNow();
  nlohmann::json& placed = place(std::move(container));
  open_.push_back({&placed, pointer, ""});
  return true;
}

bool DocumentBuilder::close() {
  open_.pop_back();
  return true;
}

std::string DocumentBuilder::nextPointer() const {
  if (open_.empty()) return "";
  const Frame& frame = open_.back();
  return frame.container->is_array()
             ? childPointer(frame.pointer, std::to_string(frame.container->size()))
             : childPointer(frame.pointer, frame.key);
}

}  // namespace suture
