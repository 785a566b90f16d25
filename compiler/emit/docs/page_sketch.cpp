#include "compiler/emit/docs/page_sketch.h"

#include <algorithm>
#include <cctype>

#include "compiler/emit/text/call_words.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

template <class Declarations, class Condition>
auto firstOf(const Declarations& all, const Condition& condition) {
  const auto found = std::find_if(all.begin(), all.end(), condition);
  return found == all.end() ? nullptr : &*found;
}

/// Returns what `text` says of each index below `count`, with commas between.
template <class Text>
std::string listed(std::size_t count, const Text& text) {
  std::string list;
  for (std::size_t i = 0; i < count; ++i) list += (i == 0 ? "" : ", ") + text(i);
  return list;
}

class Sketch {
 public:
  Sketch(const Context& context, const model::Interface& interface)
      : context_(context),
        interface_(interface),
        contract_(model::unqualified(interface.name)),
        member_(contract_ + "_") {
    member_[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(member_[0])));
    event_ = firstOf(interface.events, [](const auto& one) { return one.inheritedFrom.empty(); });
    if (!event_ && !interface.events.empty()) event_ = &interface.events.front();
  }

  std::string text() const {
    return "### Calling and serving " + contract_ + "\n\n```cpp\n" + client() + "\n" + provider() +
           "```\n\n";
  }

 private:
  std::string client() const {
    std::string code = "// A client is a component; in main() a suture::Handle does the same.\n";
    code += "class Client final : public suture::PeriodicTask {\n public:\n";
    code += "  Client() : PeriodicTask({.period = 10ms}) {" + subscription() + "}\n";
    code += "  void run() override {  // one cycle, which never waits\n";
    return code + sending() + reading() + asking() + "  }\n\n private:\n" + "  suture::Required<" +
           shown(interface_.name) + "> " + member_ + "{*this, \"" + contract_ + "\"};\n};\n";
  }

  std::string provider() const {
    const std::string emission =
        event_ ? " (void)" + member_ + ".emit()." + event_->name + "(" + values() + "); " : "";
    return "// A provider implements the contract's commands, which run in its own thread.\n"
           "class My" +
           contract_ + " final : public suture::PeriodicTask, public " + shown(interface_.name) +
           " {\n  ...\n  void run() override {" + emission + "}\n  suture::Provided<" +
           shown(interface_.name) + "> " + member_ + "{*this, \"" + contract_ + "\", *this};\n};\n";
  }

  std::string subscription() const {
    if (!event_) return "";
    const std::string parameters = listed(event_->payload.size(), [&](std::size_t i) {
      return "const " + cxx(event_->payload[i]) + "& " + valueName(i);
    });
    return "\n    " + member_ + ".on()." + event_->name + "([this](" + parameters +
           ") { ... });  // before run()\n  ";
  }

  std::string sending() const {
    const auto* one = firstOf(interface_.commands, [](const model::Command& command) {
      return command.kind == model::CommandKind::Write;
    });
    if (!one) one = firstOf(interface_.commands, isQueued);
    if (!one || one->result) return "";
    return "    if (const auto sent = " + member_ + "." + one->name + "(" + arguments(*one) +
           "); !sent) return;  // sent.error()\n";
  }

  std::string reading() const {
    const auto* const one = firstOf(interface_.commands, isRead);
    if (!one) return "";
    return "    const suture::Sample<" + cxx(*one->result) + "> sample = " + member_ + "." +
           one->name + "();  // a copy with stamp() and age()\n" +
           "    if (!sample) return;  // sample.error()\n";
  }

  std::string asking() const {
    const auto* const one = firstOf(interface_.commands, isAnswered);
    if (!one) return "";
    return "    " + member_ + "." + one->name + ".start(" + arguments(*one) +
           ").then([this](const suture::Result<" + cxx(*one->result) + ">& answer) { ... });\n";
  }

  static std::string arguments(const model::Command& command) {
    const auto& all = command.parameters;
    return listed(all.size(), [&](std::size_t i) { return all[i].name; });
  }

  std::string values() const {
    return listed(event_->payload.size(), [&](std::size_t i) { return valueName(i); });
  }

  std::string valueName(std::size_t index) const {
    return event_->payload.size() == 1 ? "value" : "value" + std::to_string(index + 1);
  }

  std::string shown(const std::string& name) const {
    return relative(name, context_.header.cxxNamespace);
  }
  std::string cxx(const model::Type& type) const {
    return cxxType(type, context_.header.cxxNamespace);
  }

  const Context& context_;
  const model::Interface& interface_;
  const std::string contract_;
  std::string member_;
  const model::Event* event_;
};

}  // namespace

std::string sketch(const Context& context, const model::Interface& interface) {
  return interface.commands.empty() && interface.events.empty() ? ""
                                                                : Sketch(context, interface).text();
}

}  // namespace suture::compiler::emit
