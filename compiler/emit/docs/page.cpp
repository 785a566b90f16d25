#include "compiler/emit/docs/page.h"

#include <filesystem>
#include <string_view>

#include "compiler/emit/docs/markdown.h"
#include "compiler/emit/docs/page_commands.h"
#include "compiler/emit/docs/page_sketch.h"
#include "compiler/emit/docs/page_types.h"
#include "compiler/emit/text/call_words.h"
#include "compiler/lock/major_versions.h"
#include "compiler/lock/schema/lock.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

std::string contractHeading(const std::string& name) {
  return model::unqualified(name) + " (contract)";
}

std::string componentHeading(const std::string& name) {
  return model::unqualified(name) + " (component)";
}

/// Returns the include root below which a header was found: pages of one root lie in one tree.
std::string_view rootOf(const model::Header& header) {
  const std::string_view file = header.file;
  return file.ends_with(header.path) ? file.substr(0, file.size() - header.path.size()) : file;
}

std::string paragraph(const std::string& text) { return text.empty() ? "" : text + "\n\n"; }

class Page {
 public:
  explicit Page(const Context& context)
      : context_(context),
        header_(context.header),
        shown_(reached(context)),
        types_(context, shown_) {}

  std::string text() const {
    std::string page = front();
    for (const model::Interface& one : header_.interfaces) page += contract(one);
    for (const model::Component& one : header_.components) page += component(one);
    const std::string types = types_.sections();
    if (!types.empty()) page += "## Data types\n\n" + types;
    page.pop_back();  // one of the two line ends
    return page;
  }

 private:
  /// Returns what contracts and components carry, then whatever else the header declares.
  static Reached reached(const Context& context) {
    Reached result(context.lookup);
    for (const model::Interface& one : context.header.interfaces) result.add(one);
    for (const model::Component& one : context.header.components) {
      if (one.parameters) result.add(*one.parameters);
    }
    for (const model::Struct& one : context.header.structs) result.add(one.name);
    for (const model::Enum& one : context.header.enums) result.add(one.name);
    return result;
  }

  std::string front() const {
    const std::string stem = model::stemOf(header_.path);
    std::string text = "# " + header_.path + "\n\n";
    text += "Reference of what " + inCode(header_.path) + " declares";
    if (!header_.cxxNamespace.empty()) text += " in namespace " + inCode(header_.cxxNamespace);
    text += ", written by suturec. Users include " + inCode(stem + ".suture.h") + ".";
    if (lock::needsLock(header_)) text += " The wire is fixed in " + inCode(stem + ".capnp") + ".";
    text += "\n\n";
    return text + contents();
  }

  std::string contents() const {
    std::string text;
    const auto add = [&text](const std::string& heading) {
      text += "- " + link(heading, anchorOf(heading)) + "\n";
    };
    for (const model::Interface& one : header_.interfaces) add(contractHeading(one.name));
    for (const model::Component& one : header_.components) add(componentHeading(one.name));
    if (text.empty()) return "";  // a page of types alone needs none
    if (!shown_.structs().empty() || !shown_.enums().empty()) add("Data types");
    return text + "\n";
  }

  std::string contract(const model::Interface& interface) const {
    const unsigned major = lock::majorOf(context_.schemas, interface.name);
    std::string facts;
    const auto add = [&facts](const std::string& fact) { facts += "- " + fact + "\n"; };
    if (!interface.base.empty()) {
      add("It has all commands and events of " + contractName(interface.base) + ".");
    }
    if (interface.crtk)
      add("Its names and payloads follow CRTK (collaborative-robotics.github.io).");
    if (interface.version > 1) add("Version " + std::to_string(interface.version) + ".");
    if (major > 1) {
      add("Wire major " + std::to_string(major) +
          ": a peer whose contract has another major is refused.");
    }
    const std::string lifecycle = lifecycleWords(interface.lifecycle);
    if (!lifecycle.empty()) add(lifecycle);
    return "## " + contractHeading(interface.name) + "\n\n" + paragraph(prose(interface.doc.text)) +
           (facts.empty() ? "" : facts + "\n") + sketch(context_, interface) +
           commandSections(context_, types_, interface);
  }

  std::string component(const model::Component& component) const {
    const bool task = component.base == model::ComponentBase::Task;
    std::string text = "## " + componentHeading(component.name) + "\n\n";
    text += paragraph(prose(component.doc.text));
    text +=
        task ? "A task: it has a thread of its own." : "A device: it runs in its callers' threads.";
    text += component.parameters
                ? " Made from " + types_.words(*component.parameters) + " in a deployment file.\n\n"
                : " Made without parameters.\n\n";
    return text + ports(component);
  }

  std::string ports(const model::Component& component) const {
    MarkdownTable table({"interface", "", "contract", "about"});
    for (const model::Port& port : component.ports) {
      std::string about = port.optional ? "May stay unconnected." : "";
      if (port.maxAgeNanoseconds) {
        about += (about.empty() ? "" : " ") + std::string("Of no use when older than ") +
                 durationWords(*port.maxAgeNanoseconds) + ".";
      }
      const std::string name = port.name.empty() ? port.member : port.name;
      table.add({inCode(name), port.provided ? "provided" : "required",
                 contractName(port.interface), about});
    }
    return table.text();
  }

  /// Returns a link to where the contract is described, if that is a page of the same tree.
  std::string contractName(const std::string& name) const {
    std::string shown = inCode(relative(name, header_.cxxNamespace));
    const model::Header* const home = context_.lookup.headerOf(name);
    if (!home || !(home->own || rootOf(*home) == rootOf(header_))) return shown;
    const std::string anchor = anchorOf(contractHeading(name));
    if (home->path == header_.path) return link(shown, anchor);
    const std::filesystem::path page = model::stemOf(home->path) + ".suture.md";
    const std::filesystem::path here = std::filesystem::path(header_.path).parent_path();
    return link(shown, page.lexically_relative(here.empty() ? "." : here).string() + anchor);
  }

  const Context& context_;
  const model::Header& header_;
  const Reached shown_;
  const PageTypes types_;
};

}  // namespace

std::string emitPage(const Context& context) { return Page(context).text(); }

}  // namespace suture::compiler::emit
