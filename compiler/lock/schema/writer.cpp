#include "compiler/lock/schema/writer.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdio>
#include <set>
#include <sstream>
#include <vector>

#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/naming.h"

namespace suture::compiler::lock {
namespace {

constexpr std::size_t kColumns = 100;

/// Maps the path of another schema file to the name under which it is imported.
using Aliases = std::map<std::string, std::string>;

/// Makes a name for capnp of what a file or folder is called: "MyArm" of "my-arm", "File3d" of
/// "3d".
std::string titleOf(const std::string& name) {
  const std::string title = model::titleCase(model::camelCase(model::plainPath(name)));
  const bool named = !title.empty() && std::isupper(static_cast<unsigned char>(title.front()));
  return named ? title : "File" + title;
}

/// Makes "RobotTypes" of "/robot_types/robot_types.capnp"; `full` puts the folder's name in front.
std::string aliasOf(const std::string& path, bool full) {
  const std::string stem = model::stemOf(path).substr(1);
  const std::size_t slash = stem.rfind('/');
  if (slash == std::string::npos) return titleOf(stem);
  std::string folder = titleOf(stem.substr(0, slash));
  for (std::size_t i; (i = folder.find('/')) != std::string::npos;) folder.erase(i, 1);
  return (full ? folder : "") + titleOf(stem.substr(slash + 1));
}

void collectPaths(const std::string& type, std::set<std::string>& paths) {
  const std::size_t begin = type.find('/');
  if (begin != std::string::npos) paths.insert(type.substr(begin, type.find(':', begin) - begin));
}

void collectPaths(const Member& member, std::set<std::string>& paths) {
  collectPaths(member.type, paths);
  for (const Member& parameter : member.parameters) collectPaths(parameter, paths);
  for (const Member& result : member.results) collectPaths(result, paths);
}

Aliases aliasesOf(const Lock& lock) {
  std::set<std::string> paths;
  std::set<std::string> taken = {"Cxx", "Meta"};
  for (const Node& node : lock.nodes) {
    taken.insert(node.name);
    for (const std::string& base : node.extends) collectPaths(base, paths);
    for (const Member& member : node.members) collectPaths(member, paths);
  }
  Aliases aliases;
  for (const std::string& path : paths) {
    std::string alias = aliasOf(path, false);
    if (taken.contains(alias)) alias = aliasOf(path, true);
    while (taken.contains(alias)) alias += "File";
    taken.insert(alias);
    aliases.emplace(path, alias);
  }
  return aliases;
}

/// Turns "List(/arm/arm.capnp:Pose)" into "List(Arm.Pose)".
std::string spell(const std::string& type, const Aliases& aliases) {
  const std::size_t begin = type.find('/');
  if (begin == std::string::npos) return type;
  const std::size_t colon = type.find(':', begin);
  const std::string path = type.substr(begin, colon - begin);
  const auto alias = aliases.find(path);
  const std::string shown = alias == aliases.end() ? aliasOf(path, false) : alias->second;
  return type.substr(0, begin) + shown + "." + type.substr(colon + 1);
}

std::vector<std::string> spell(const Annotations& annotations) {
  std::vector<std::string> pieces;
  for (const auto& [name, argument] : annotations) {
    const bool wrapped = !argument.empty() && argument.front() == '(';
    pieces.push_back("$Meta." + name +
                     (argument.empty() || wrapped ? argument : "(" + argument + ")"));
  }
  return pieces;
}

std::string spellList(const std::vector<Member>& members, const Aliases& aliases) {
  std::string text;
  for (const Member& member : members) {
    if (!text.empty()) text += ", ";
    text += member.name + " :" + spell(member.type, aliases);
    for (const std::string& piece : spell(member.annotations)) text += " " + piece;
  }
  return "(" + text + ")";
}

std::string head(const Member& member, const Aliases& aliases) {
  std::string text = member.name + " @" + std::to_string(member.ordinal);
  if (member.isMethod) {
    return text + " " + spellList(member.parameters, aliases) + " -> " +
           spellList(member.results, aliases);
  }
  if (!member.type.empty()) text += " :" + spell(member.type, aliases);
  if (!member.defaultValue.empty()) text += " = " + member.defaultValue;
  return text;
}

/// Fills lines of at most kColumns, and breaks them only between pieces.
std::string fill(std::string line, const std::vector<std::string>& pieces, const char* end,
                 const std::string& indent) {
  std::string text;
  for (const std::string& piece : pieces) {
    if (line.size() + 1 + piece.size() + 1 > kColumns) {
      text += line + "\n";
      line = indent + piece;
    } else {
      line += " " + piece;
    }
  }
  return text + line + end;
}

std::string comment(const std::string& doc, const std::string& indent) {
  std::istringstream lines(doc);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    text += line.empty() ? indent + "#\n" : indent + "# " + line + "\n";
  }
  return text;
}

const char* keyword(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::Struct: return "struct";
    case Node::Kind::Enum: return "enum";
    case Node::Kind::Interface: return "interface";
  }
  return "";
}

std::string spellBases(const std::vector<std::string>& bases, const Aliases& aliases) {
  std::string text;
  for (const std::string& base : bases) text += (text.empty() ? "" : ", ") + spell(base, aliases);
  return text.empty() ? "" : " extends(" + text + ")";
}

std::string write(const Node& node, const Aliases& aliases) {
  std::string text = fill(std::string(keyword(node.kind)) + " " + node.name + " " +
                              idText(node.id) + spellBases(node.extends, aliases),
                          spell(node.annotations), " {\n", "    ");
  text += comment(node.doc, "  ");
  if (!node.doc.empty() && !node.members.empty()) text += "\n";
  const std::string indent = node.isUnion ? "    " : "  ";
  if (node.isUnion) text += "  union {\n";
  for (const Member& member : node.members) {
    text += fill(indent + head(member, aliases), spell(member.annotations), ";\n", indent + "    ");
    text += comment(member.doc, indent);
  }
  return text + (node.isUnion ? "  }\n}\n" : "}\n");
}

}  // namespace

std::string idText(std::uint64_t id) {
  char text[24];
  std::snprintf(text, sizeof text, "@0x%016llx", static_cast<unsigned long long>(id));
  return text;
}

std::string write(const Lock& lock) {
  return write(lock, "# The wire contract of " + lock.header +
                         ", written by suturec --update-lock: commit it, never edit it.\n");
}

std::string write(const Lock& lock, const std::string& about) {
  const Aliases aliases = aliasesOf(lock);
  std::string text = idText(lock.id) + ";\n" + about + "\n";
  text += "using Cxx = import \"/capnp/c++.capnp\";\nusing Meta = import \"/suture/meta.capnp\";\n";
  for (const auto& [path, alias] : aliases) {
    text += "using " + alias + " = import " + quoted(path) + ";\n";
  }
  text += "$Cxx.namespace(" + quoted(model::wireNamespace(lock.cxxNamespace)) + ");\n";
  text += "$Meta.header(" + quoted(lock.header) + ");\n";
  for (const Departure& one : lock.departures) {
    text +=
        "$Meta.formerly(" + quoted(one.name + " " + idText(one.id) + " " + one.to.text()) + ");\n";
  }
  for (const Node& node : lock.nodes) text += "\n" + write(node, aliases);
  return text;
}

std::string describe(const Member& member) {
  std::string text = head(member, {});
  for (const std::string& piece : spell(member.annotations)) text += " " + piece;
  return text;
}

}  // namespace suture::compiler::lock
