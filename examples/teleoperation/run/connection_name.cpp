#include "run/connection_name.h"

namespace demo {

std::string nameOf(const suture::ConnectionEntry& connection) {
  return connection.from.toString() + " -> " + connection.to.toString();
}

}  // namespace demo
