#include "compiler/check/type_tree.h"

#include <set>

namespace suture::compiler::check {
namespace {

using Shape = model::Type::Shape;

class Walk {
 public:
  Walk(const model::Lookup& lookup, const std::function<bool(const Place&)>& visit)
      : lookup_(lookup), visit_(visit) {}

  bool from(Place place) {
    const bool isStruct = place.type.shape == Shape::Struct;
    place.recursive = isStruct && open_.contains(place.type.name);
    if (!visit_(place)) return false;
    for (const model::Type& element : place.type.element) {
      if (!from({element, place.path + "[]", place.field})) return false;
    }
    const model::Struct* type = isStruct ? lookup_.findStruct(place.type.name) : nullptr;
    if (!type || place.recursive || done_.contains(type->name)) return true;
    open_.insert(type->name);
    const bool whole = fields(*type, place.path);
    open_.erase(type->name);
    done_.insert(type->name);
    return whole;
  }

 private:
  bool fields(const model::Struct& type, const std::string& prefix) {
    for (const model::Field& field : type.fields) {
      const std::string path = prefix.empty() ? field.name : prefix + "." + field.name;
      if (!from({field.type, path, &field})) return false;
    }
    return true;
  }

  const model::Lookup& lookup_;
  const std::function<bool(const Place&)>& visit_;
  std::set<std::string> open_;
  // Each struct is entered once. A struct may have several members of one type, and that type
  // several of a third; if each way to it were taken, the time would double with every level.
  std::set<std::string> done_;
};

}  // namespace

bool isSized(const model::Type& type) {
  return type.shape == Shape::Text || type.shape == Shape::List || type.shape == Shape::Map ||
         type.shape == Shape::AnyMatrix;
}

bool isOpen(const model::Type& type) {
  const bool matrix = type.shape == Shape::AnyMatrix;
  return isSized(type) &&
         (type.capacity.value_or(0) == 0 || (matrix && type.columnCapacity.value_or(0) == 0));
}

bool walk(const model::Type& type, const model::Lookup& lookup,
          const std::function<bool(const Place&)>& visit) {
  return Walk(lookup, visit).from({type, "", nullptr});
}

bool ownsHeap(const model::Type& type, const model::Lookup& lookup) {
  return !walk(type, lookup, [](const Place& place) {
    // Only std::unique_ptr among optionals owns heap, and only its spelling tells it apart.
    const bool pointer =
        place.type.shape == Shape::Optional && place.type.spelling.starts_with("std::unique_ptr");
    return !isSized(place.type) && !pointer;
  });
}

}  // namespace suture::compiler::check
