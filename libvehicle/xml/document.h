#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <tinyxml2.h>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

/// A file taken apart into elements; `root` is null if that could not be done.
struct Document {
  std::unique_ptr<tinyxml2::XMLDocument> tree;
  const tinyxml2::XMLElement* root = nullptr;
  ProblemList problems;
};

/// Text -> elements: guarded (text_guard.h), well formed, with one root element.
[[nodiscard]] Document parseDocument(std::string_view text, const std::string& file_name);

}  // namespace vehicle
