#pragma once

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/recorded/channel_loads.hpp"
#include "text_file.hpp"

namespace boxbeam {

/// A text file beside a case, as it was when it was first asked for.
struct KeptText {
  FileText file;
  std::vector<std::string> lines;
  std::string sha256;  ///< of its bytes
};

/// What the files hold that a case names, kept for the next time that the case is read. For several
/// threads at once.
class KeptFiles {
 public:
  /// Reads the file the first time; what cannot be read is looked for again the next time.
  std::shared_ptr<const KeptText> text_at(const std::string& path);

  /// Of a file of signals, which is not kept itself.
  std::optional<std::string> sha256_at(const std::string& path) const;
  void keep_sha256(const std::string& path, std::string sha256);

  /// Channels by all that they are made of; the last few that were kept.
  std::shared_ptr<const recorded::Channels> channels(const std::string& of) const;
  void keep_channels(std::string of, std::shared_ptr<const recorded::Channels> channels);

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const KeptText>> texts_;
  std::map<std::string, std::string> hashes_;
  std::deque<std::pair<std::string, std::shared_ptr<const recorded::Channels>>> channels_;
};

}  // namespace boxbeam
