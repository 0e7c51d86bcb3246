// armlet help --lists: what there is, as JSON: for documents that are made from it, and for
// editors.

#include <nlohmann/json.hpp>

#include "armlet/backend/trace_format.hpp"
#include "armlet/model/catalog.hpp"
#include "console.hpp"

namespace armlet::cli {
namespace {

using Json = nlohmann::ordered_json;

Json robots() {
  Json list = Json::array();
  for (const CatalogArm& entry : catalog_arms()) {
    list.push_back({{"name", entry.name},
                    {"secondName", entry.second_name},
                    {"source", entry.source},
                    {"help", entry.help}});
  }
  return list;
}

Json traces() {
  Json list = Json::array();
  for (const TraceFormat& format : trace_formats())
    list.push_back({{"ending", format.ending}, {"holds", format.holds}});
  return list;
}

}  // namespace

int lists() {
  print_out(Json({{"robots", robots()}, {"traces", traces()}}).dump(1) + "\n");
  return finish_output() ? kDone : kFailed;
}

}  // namespace armlet::cli
