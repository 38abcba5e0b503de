#include "kept_files.hpp"

#include <algorithm>

#include "boxbeam/project/case_document.hpp"

namespace boxbeam {

std::shared_ptr<const KeptText> KeptFiles::text_at(const std::string& path) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = texts_.find(path);
    if (known != texts_.end()) return known->second;
  }
  const auto text = std::make_shared<KeptText>();
  text->file = read_regular_file(path);
  if (text->file.trouble != FileText::Trouble::none) return text;
  text->lines = split_lines(text->file.text);
  text->sha256 = sha256_of(text->file.text);
  const std::lock_guard lock(mutex_);
  return texts_.emplace(path, text).first->second;
}

std::optional<std::string> KeptFiles::sha256_at(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  const auto known = hashes_.find(path);
  return known != hashes_.end() ? std::optional(known->second) : std::nullopt;
}

void KeptFiles::keep_sha256(const std::string& path, std::string sha256) {
  const std::lock_guard lock(mutex_);
  hashes_.emplace(path, std::move(sha256));
}

std::shared_ptr<const recorded::Channels> KeptFiles::channels(const std::string& of) const {
  const std::lock_guard lock(mutex_);
  const auto known = std::find_if(channels_.begin(), channels_.end(),
                                  [&](const auto& kept) { return kept.first == of; });
  return known != channels_.end() ? known->second : nullptr;
}

void KeptFiles::keep_channels(std::string of, std::shared_ptr<const recorded::Channels> channels) {
  constexpr std::size_t most = 8;  // long records are large
  const std::lock_guard lock(mutex_);
  channels_.emplace_back(std::move(of), std::move(channels));
  if (channels_.size() > most) channels_.pop_front();
}

}  // namespace boxbeam
