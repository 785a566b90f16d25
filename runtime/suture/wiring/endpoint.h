#pragma once
// A deployment names an interface of a component like this: "process:component/interface".

#include <string>
#include <string_view>

namespace suture {

/// An Endpoint is one end of a connection.
struct Endpoint {
  std::string process;  ///< "": the process that reads the name
  std::string component;
  std::string interface;

  /// Reads "process:component/interface" or "component/interface". Throws SetupError.
  static Endpoint parse(std::string_view text);
  std::string toString() const;
};

/// Returns what a connection is called: "console:Teleop/Slave -> robot:PSM/Arm".
std::string connectionName(const Endpoint& from, const Endpoint& to);

}  // namespace suture
