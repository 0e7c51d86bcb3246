#include "armlet/stdlib/session.hpp"
#include "library_text.hpp"

namespace armlet {

WorldText table_world() { return {"table", std::string(library_text("table.rbt").value())}; }

}  // namespace armlet
