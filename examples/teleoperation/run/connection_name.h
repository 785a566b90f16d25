#pragma once
// How reports call a connection.

#include <suture/deploy/document/deployment.h>

#include <string>

namespace demo {

/// "left:TeleopL/Slave -> right:PSM1/Arm".
std::string nameOf(const suture::ConnectionEntry& connection);

}  // namespace demo
