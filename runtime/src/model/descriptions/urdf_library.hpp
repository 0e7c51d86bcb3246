#pragma once

#include <urdf_model/model.h>

#include <memory>
#include <string>

namespace armlet {

// What urdfdom made of a description, and the first fault that it reported, with the name of the
// link or joint if it says one.
struct ParsedUrdf {
  std::shared_ptr<urdf::ModelInterface> model;
  std::string reason;
};

ParsedUrdf parse_urdf(const std::string& text);

}  // namespace armlet
