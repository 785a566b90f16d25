#include "bench/table2/overhead.h"

#include <fmt/format.h>

#include "bench/figures/table.h"
#include "bench/table2/paper.h"

namespace bench {
namespace {

// A loop carries the value across twice and hands it to a method twice.
constexpr double kCrossings = 2;

struct Parts {
  double total, preparation, execution;

  double transmission() const { return total - preparation - execution; }
};

Parts partsOf(const std::string& loop, const CodecCost& codec, const Statistics& execution,
              Report& report) {
  const Parts parts{.total = report.find("event." + loop + ".difference").value().value,
                    .preparation = kCrossings * codec.sum.p50 / kMicrosecond,
                    .execution = kCrossings * execution.p50 / kMicrosecond};
  const std::string figure = "overhead." + loop;
  report.add(figure + ".preparation", "us", parts.preparation);
  report.add(figure + ".transmission", "us", parts.transmission());
  report.add(figure + ".execution", "us", parts.execution);
  return parts;
}

std::string partsTable(const Parts& scs, const Parts& csc) {
  Table table(1);
  table.row({"", "SCS", "CSC"});
  table.line();
  const auto row = [&](const char* title, double ofScs, double ofCsc) {
    table.row({title, number(ofScs, 2), number(ofCsc, 2)});
  };
  row("preparation and recovery (serialization, creation, deserialization)", scs.preparation,
      csc.preparation);
  row("transmission (sockets, Cap'n Proto RPC, threads)", scs.transmission(), csc.transmission());
  row("execution (casts, dereferences, virtual call)", scs.execution, csc.execution);
  table.line();
  row("network - local, medians", scs.total, csc.total);
  return table.toString();
}

std::string codecTable(const CodecCost& codec, const Statistics& execution) {
  Table table(1);
  table.row(joined({"one PosePrm"}, statisticsTitles()));
  table.line();
  table.row(joined({"serialize"}, cellsOf(codec.encode, 0)));
  table.row(joined({"create"}, cellsOf(codec.create, 0)));
  table.row(joined({"deserialize"}, cellsOf(codec.decode, 0)));
  table.row(joined({"serialize + create + deserialize"}, cellsOf(codec.sum, 0)));
  table.row(joined({"execution"}, cellsOf(execution, 0)));
  return table.toString();
}

}  // namespace

void addOverhead(const CodecCost& codec, const Statistics& execution, Report& report) {
  report.add("codec.encode", "ns", codec.encode);
  report.add("codec.create", "ns", codec.create);
  report.add("codec.decode", "ns", codec.decode);
  report.add("codec.sum", "ns", codec.sum);
  report.add("codec.bytes", "bytes", static_cast<double>(codec.bytes));
  report.add("execution", "ns", execution);
}

std::string overheadRows(const CodecCost& codec, const Statistics& execution, Report& report) {
  const Parts scs = partsOf("scs", codec, execution, report);
  const Parts csc = partsOf("csc", codec, execution, report);
  return fmt::format(
      "What the network adds to one loop, in the paper's three parts; us\n\n{}\n"
      "Preparation and recovery, and execution, in loops of {} ({} bytes); ns\n\n{}\n"
      "The paper: {:.0f} ns for the three on {}, {:.0f} on {}; there too transmission is nearly "
      "all "
      "of the overhead.\n",
      partsTable(scs, csc), kCodecLoop, codec.bytes, codecTable(codec, execution),
      paper::kLinuxRtai.codec * 1e6, paper::kLinuxRtai.name, paper::kLinux.codec * 1e6,
      paper::kLinux.name);
}

}  // namespace bench
