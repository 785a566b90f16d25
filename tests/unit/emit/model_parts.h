#pragma once
// These make the parts of a model by hand: no clang, no headers to parse.

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "compiler/model/model.h"

namespace suture::compiler::sample {

model::Type scalar(model::Scalar scalar);
model::Type number();  ///< double
model::Type text(unsigned capacity);
model::Type listOf(model::Type element, unsigned capacity);
model::Type arrayOf(model::Type element, unsigned length);
model::Type matrix(unsigned rows, unsigned columns, model::Scalar scalar = model::Scalar::Float64);
model::Type quaternion();
model::Type isometry();
model::Type milliseconds();
model::Type steadyTime();
model::Type enumeration(const std::string& name);
model::Type record(const std::string& name);

model::Field field(const std::string& name, model::Type type, const std::string& unit = "");
model::Struct structure(const std::string& name, std::vector<model::Field> fields);
model::Enum enumerated(const std::string& name,
                       std::initializer_list<std::pair<const char*, std::int64_t>> enumerators);
model::Command command(const std::string& name, model::CommandKind kind);
model::Command read(const std::string& name, model::Type result);
model::Command write(const std::string& name, const std::string& parameter, model::Type type);
model::Event event(const std::string& name, std::vector<model::Type> payload = {});

}  // namespace suture::compiler::sample
