/// The page of a live run: the replay's page without recorded data, which asks the server for them.
#pragma once
#include <string>

#include "live/driven_run.hpp"

namespace dynamy::app {

std::string livePage(const DrivenRun& run);

/// Opens the page in the browser by way of a file in the run's folder that only its owner can read:
/// the list of processes, which everybody can read, does not show the token. The file is removed
/// with the object.
class LiveDoor {
 public:
  /// Throws WriteError.
  LiveDoor(const RunFolder& folder, const std::string& address);
  ~LiveDoor();
  LiveDoor(const LiveDoor&) = delete;
  LiveDoor& operator=(const LiveDoor&) = delete;
  /// False: no browser was found.
  bool open() const;

 private:
  std::filesystem::path file_;
};

}  // namespace dynamy::app
