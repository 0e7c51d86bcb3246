#pragma once
// The user's browser, where there is a screen.

#include <filesystem>
#include <string>

namespace armlet::cli {

// Opens addresses that hold a secret. Browsers are started with what they open on their command
// line, which every user of the machine can read: that is a file of this user, which leads to the
// address. It lives as long as this.
class BrowserOpener {
 public:
  BrowserOpener() = default;
  ~BrowserOpener();
  BrowserOpener(const BrowserOpener&) = delete;
  BrowserOpener& operator=(const BrowserOpener&) = delete;

  // Nothing happens where there is no screen, no place for the file or no browser.
  void open(const std::string& address);

 private:
  std::filesystem::path folder_;  // of the file; empty: there is none
};

}  // namespace armlet::cli
