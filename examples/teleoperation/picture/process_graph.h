#pragma once
// These are the processes of a run, what lies between them, and how old it was when it arrived.

#include <suture/base/time.h>
#include <suture/observe/report.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "picture/canvas.h"
#include "run/plan.h"

namespace demo {

struct ProcessGraph {
  struct Process {
    std::string name;
    std::size_t components = 0;
  };
  /// Holds all connections between two processes, in either direction.
  struct Link {
    std::size_t first = 0, second = 0;  ///< where they stand in `processes`
    std::size_t connections = 0;
    std::set<std::string> lanes;
    suture::Duration reads{0}, commands{0};  ///< the greatest p99 of all; 0: there were none
  };

  std::vector<Process> processes;
  std::vector<Link> links;
};

/// Leaves out connections within a process, because nothing lies between their ends.
ProcessGraph processGraph(const Plan& plan, const std::vector<suture::ConnectionReport>& reports);

/// Draws the graph into the rows from `top` on, over the whole width of the canvas.
void drawGraph(picture::Canvas& canvas, const ProcessGraph& graph, int top);
constexpr int kGraphHeight = 300;  ///< px

}  // namespace demo
