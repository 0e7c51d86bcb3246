#pragma once

#include <urdf_model/model.h>

#include <memory>
#include <string>

namespace armlet {

// The result of urdfdom for a description, and the first error that it reported, with the name of
// the link or joint if there is one.
struct ParsedUrdf {
  std::shared_ptr<urdf::ModelInterface> model;
  std::string reason;
};

ParsedUrdf parse_urdf(const std::string& text);

}  // namespace armlet
