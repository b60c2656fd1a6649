#include "schemes/scheme.hpp"

#include "algebra/error.hpp"

namespace limes {

std::string to_string(SchemeKind kind) {
  switch (kind) {
    case SchemeKind::uniform: return "uniform";
    case SchemeKind::nonuniform: return "nonuniform";
    case SchemeKind::nonstationary: return "nonstationary";
    case SchemeKind::surface: return "surface";
  }
  throw InternalError("unknown kind of scheme");
}

VariableNames Scheme::parameter_names() const {
  VariableNames names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  return names;
}

Box Scheme::parameter_box() const {
  Box box;
  for (const Parameter& parameter : parameters) box.push_back(parameter.range);
  return box;
}

}  // namespace limes
