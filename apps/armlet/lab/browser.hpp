#pragma once
// Opens the user's browser, if there is a display.

#include <filesystem>
#include <string>

namespace armlet::cli {

// Opens addresses that contain a secret. Every user of the computer can read the command line of a
// browser; so the browser gets a file of this user, which redirects to the address. The file exists
// as long as this object.
class BrowserOpener {
 public:
  BrowserOpener() = default;
  ~BrowserOpener();
  BrowserOpener(const BrowserOpener&) = delete;
  BrowserOpener& operator=(const BrowserOpener&) = delete;

  // Does nothing if there is no display, no folder for the file or no browser.
  void open(const std::string& address);

 private:
  std::filesystem::path folder_;  // of the file; empty: there is none
};

}  // namespace armlet::cli
