#include "recorder/knot_recording.h"

#include <suture/base/time.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <ostream>

#include "recorder/json_stamp.h"
#include "recorder/recording_lines.h"

namespace robots {
namespace {

using Json = nlohmann::json;

template <class Matrix>
Json toJson(const Matrix& matrix) {
  Json list = Json::array();
  for (const double value : matrix.reshaped()) list.push_back(value);
  return list;
}

template <class Matrix>
void read(const Json& list, Matrix& matrix) {
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    matrix.reshaped()[i] = list.at(static_cast<std::size_t>(i)).template get<double>();
  }
}

KnotRow toRow(const Json& json) {
  KnotRow row;
  row.strand.stamp = stampOf(json.at("stamp"));
  read(json.at("nodes"), row.strand.nodes);
  row.strand.left_length = json.at("left_length").get<double>();
  row.strand.left_tension = json.at("left_tension").get<double>();
  row.strand.right_tension = json.at("right_tension").get<double>();
  row.strand.valid = true;
  read(json.at("camera"), row.camera.matrix());
  row.tissue = json.at("tissue").get<double>();
  row.guiding = json.at("guiding").get<bool>();
  const Json& seen = json.at("seen");
  row.sighting.valid = !seen.is_null();
  if (row.sighting.valid) {
    row.sighting.stamp = stampOf(seen.at("stamp"));
    read(seen.at("knot"), row.sighting.knot);
    read(seen.at("left"), row.sighting.left_tip);
    read(seen.at("right"), row.sighting.right_tip);
  }
  return row;
}

}  // namespace

void write(std::ostream& out, const KnotRow& row) {
  Json seen;
  if (row.sighting.valid) {
    seen = {{"stamp", suture::toNanoseconds(row.sighting.stamp)},
            {"knot", toJson(row.sighting.knot)},
            {"left", toJson(row.sighting.left_tip)},
            {"right", toJson(row.sighting.right_tip)}};
  }
  out << Json{{"stamp", suture::toNanoseconds(row.strand.stamp)},
              {"nodes", toJson(row.strand.nodes)},
              {"left_length", row.strand.left_length},
              {"left_tension", row.strand.left_tension},
              {"right_tension", row.strand.right_tension},
              {"camera", toJson(row.camera.matrix())},
              {"tissue", row.tissue},
              {"seen", seen},
              {"guiding", row.guiding}}
      << '\n';
}

KnotRecording readKnotRecording(const std::filesystem::path& file) {
  KnotRecording recording;
  RecordingLines lines(file);
  lines.rest([&](const Json& json) { recording.rows.push_back(toRow(json)); });
  recording.lost = lines.lost();
  return recording;
}

}  // namespace robots
