#pragma once
// This finds what differs between two topologies.

#include <suture/deploy/document/deployment.h>

#include <string>
#include <vector>

namespace demo {

/// A Difference is a value in one of two deployments and in the other; "-" stands for what is not
/// there.
struct Difference {
  std::string subject, first, second;
};

/// Holds the differences, which are found only from the files: where components run, what their
/// entries say, what connects them. A component is the same one in both if its name is the same,
/// wherever it runs.
struct Comparison {
  std::vector<Difference> places;       ///< the process in which a component runs
  std::vector<Difference> settings;     ///< any value of a component, a process or a connection
  std::vector<Difference> connections;  ///< who provides what a required interface needs
  std::size_t equalPlaces = 0, equalConnections = 0;
};

Comparison compare(const suture::Deployment& first, const suture::Deployment& second);

/// Returns the comparison for people, with the two files as titles.
std::string describe(const Comparison& comparison, const std::string& first,
                     const std::string& second);

}  // namespace demo
