#pragma once
// This is the name of a connection in reports.

#include <suture/deploy/document/deployment.h>

#include <string>

namespace demo {

/// Returns for example "left:TeleopL/Slave -> right:PSM1/Arm".
std::string nameOf(const suture::ConnectionEntry& connection);

}  // namespace demo
