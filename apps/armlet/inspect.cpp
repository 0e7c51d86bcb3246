// armlet disasm and armlet explain.

#include <fmt/format.h>

#include <vector>

#include "armlet/core/similar.hpp"
#include "armlet/interpreter/messages/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "console/console.hpp"
#include "console/setup.hpp"

namespace armlet::cli {

int disasm(const ProgramOptions& options, const std::string& file) {
  auto text = read_file(file, options.json);
  if (!text) return kNoFile;
  Setup setup = make_setup(options, file);
  if (setup.exit != kDone) return setup.exit;
  Session session(library_engine(), std::move(setup.session));
  const bool good = session.compile(*std::move(text), file);
  show(session.problems(), options.json);
  if (!good) return kRejected;
  print_out(session.program()->disassemble());
  return finish_output() ? kDone : kFailed;
}

int explain(const std::string& code) {
  const MessageTables& messages = library_engine().messages();
  if (code.empty()) {
    for (const CatalogEntry* entry : messages.all())
      print_out(fmt::format("{}  {}\n", entry->code, entry->headline));
    return finish_output() ? kDone : kFailed;
  }
  std::string wanted = code;
  for (char& c : wanted) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
  }
  if (const CatalogEntry* entry = messages.find(wanted)) {
    print_out(explain_page(*entry));
    return finish_output() ? kDone : kFailed;
  }
  std::vector<std::string_view> codes;
  for (const CatalogEntry* entry : messages.all()) codes.push_back(entry->code);
  std::string message = fmt::format("armlet: there is no message {}", code);
  if (const auto meant = most_similar(wanted, codes))
    message += fmt::format("; did you mean {}?", *meant);
  progress(message + " `armlet explain` lists all of them.");
  return kUsage;
}

}  // namespace armlet::cli
