#include "harness/options.h"

#include "harness/fail.h"

namespace peers {

Options parsedOptions(int count, char** arguments) {
  if (count < 4) fail("usage: PROGRAM VARIANT ROLE MEASUREMENT [--NAME VALUE]...");
  Options options;
  options.variant = arguments[1];
  options.role = arguments[2];
  options.measurement = arguments[3];
  for (int i = 4; i + 1 < count; i += 2) {
    const std::string name = arguments[i], value = arguments[i + 1];
    if (name == "--control") {
      options.control = value;
    } else if (name == "--place") {
      options.place = value;
    } else if (name == "--port") {
      options.port = std::stoi(value);
    } else if (name == "--cpu") {
      options.cpu = std::stoi(value);
    } else if (name == "--server") {
      options.server = std::stoi(value);
    } else if (name == "--servers") {
      options.servers = std::stoi(value);
    } else if (name == "--count") {
      options.count = std::stol(value);
    } else if (name == "--seconds") {
      options.seconds = std::stod(value);
    } else {
      fail("there is no option " + name);
    }
  }
  return options;
}

}  // namespace peers
