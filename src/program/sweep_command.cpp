#include "program/sweep_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/study_report.hpp"
#include "program/chunk_store.hpp"
#include "program/column_file.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/ranks.hpp"
#include "program/study_designs.hpp"
#include "program/study_publication.hpp"
#include "program/terminal.hpp"
#include "report/text_layout.hpp"
#include "report/unfinished.hpp"

namespace boxbeam::program {
namespace {

namespace fs = std::filesystem;

/// Which part of a study is asked for: of each `count` chunks the one of this index.
struct Shard {
  std::size_t index = 0, count = 1;
};

Shard shard_in(const std::string& text) {
  if (text.empty()) return {};
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto [slash, error] = std::from_chars(text.data(), end, shard.index);
  bool good = error == std::errc{} && slash != end && *slash == '/';
  if (good) {
    const auto [last, wrong] = std::from_chars(slash + 1, end, shard.count);
    good = wrong == std::errc{} && last == end && shard.index >= 1 && shard.index <= shard.count;
  }
  if (!good)
    throw InputError(fmt::format("--shard: \"{}\" is no part of a whole", text),
                     "write --shard 2/8 for the second of eight parts");
  --shard.index;
  return shard;
}

/// Of a study of so many designs; by their number alone, so that whoever works on it has the same
/// chunks. Small ones for a small study, so that all threads have work; a ten-thousandth of a large
/// one, so that folders stay small; no more than a process can hold the rows of.
std::size_t chunk_size(std::size_t designs) {
  constexpr std::size_t most = 100'000;
  return std::max(std::clamp<std::size_t>(designs / 64, 1, 64), std::min(designs / 10'000, most));
}

/// "2 min 5 s".
std::string duration_text(double seconds) {
  const long long whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

/// The chunks of a study that are still to be done, by several threads.
class Sweep {
 public:
  Sweep(const StudyDesigns& designs, const Manifest& manifest, const ChunkStore& store,
        std::vector<std::size_t> chunks, Ranks& ranks)
      : designs_(&designs),
        manifest_(&manifest),
        store_(&store),
        chunks_(std::move(chunks)),
        ranks_(&ranks) {}

  void run(std::size_t threads, Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    std::size_t total = 0;
    for (const std::size_t chunk : chunks_) total += manifest_->rows_in(chunk);
    {
      std::vector<std::jthread> workers;
      for (std::size_t i = 0; i < std::min(threads, chunks_.size()); ++i)
        workers.emplace_back([this] { work(); });
      while (!finished(workers.size())) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ranks_->serve();
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        const double rate = static_cast<double>(done_) / passed.count();
        const double left = rate > 0.0 ? static_cast<double>(total - done_) / rate : 0.0;
        progress.now(fmt::format("{} of {} designs, {:.3g} per second, {} left, {} failed",
                                 done_.load(), total, rate, duration_text(left), failed_.load()));
      }
    }
    const bool anywhere = ranks_->any(trouble_ != nullptr);
    if (trouble_) std::rethrow_exception(trouble_);
    if (anywhere) throw EndedElsewhere{};
  }

 private:
  bool finished(std::size_t workers) const { return ended_ >= workers; }

  void work() {
    for (;;) {
      const std::size_t next = ranks_->next();
      if (next >= chunks_.size() || stop_) break;
      try {
        do_chunk(chunks_[next]);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!trouble_) trouble_ = std::current_exception();
        stop_ = true;
      }
    }
    ++ended_;
  }

  void do_chunk(std::size_t chunk) {
    ChunkRows rows(*manifest_);
    for (std::size_t i = 0; i < manifest_->rows_in(chunk); ++i) {
      if (stop_) return;
      const StudyDesigns::Row row = designs_->row(chunk * manifest_->chunk + i);
      rows.take(row);
      failed_ += row.failed ? 1 : 0;
      ++done_;
    }
    const std::lock_guard lock(mutex_);
    store_->write(chunk, std::move(rows).lines());
  }

  const StudyDesigns* designs_;
  const Manifest* manifest_;
  const ChunkStore* store_;
  std::vector<std::size_t> chunks_;
  Ranks* ranks_;
  std::atomic<std::size_t> done_{0}, failed_{0}, ended_{0};
  std::atomic<bool> stop_{false};
  std::mutex mutex_;  ///< of the store and the trouble
  std::exception_ptr trouble_;
};

std::size_t threads_of(const SweepOptions& options) {
  if (options.threads > 0) return options.threads;
  return std::max(1U, std::thread::hardware_concurrency());
}

/// A study of a limit state alone has no results that could be listed design by design.
void require_designs(const Study& study) {
  if (study.columns.empty())
    throw InputError(fmt::format("{}: the study has no case and no formula", study.path),
                     "write case = \"rig.toml\" in [study], or columns = [\"f = a + b\"] in "
                     "[results]");
  const bool scatters = std::any_of(study.variables.begin(), study.variables.end(),
                                    [](const Variable& of) { return of.distribution.has_value(); });
  if (scatters && study.samples == 0)
    throw InputError(fmt::format("{}: the study says not how many designs are drawn", study.path),
                     "write samples = 1000 in [study]");
}

int say(const PublishedStudy& study, const std::string& folder, const std::string& json) {
  report::MarkedText text = study_text(study.summary);
  text +=
      "\n" + layout::line(fmt::format("Written to {}: {}", folder, fmt::join(study.files, ", ")));
  put_result(json, study_json(study.summary), text);
  return study.summary.failed == study.summary.designs ? not_possible : all_pass;
}

/// A study that has ended: its rows are taken as they stand, what follows from them is written
/// anew.
int say_again(const Manifest& manifest, const std::string& folder, const SweepOptions& options) {
  const bool netcdf = options.netcdf || fs::exists(fs::path(folder) / "rows.nc");
  const PublishedStudy study =
      publish_study(manifest, folder, netcdf, rows_that_stand(manifest, folder));
  // Where JSON goes to the terminal nothing else may.
  if (options.json != "-")
    put_text(
        layout::line(fmt::format("All {} designs of this study stand in {}: none is verified again",
                                 manifest.designs, folder)));
  return say(study, folder, options.json);
}

/// Chunks of an earlier run must be of this study.
void begin_store(const ChunkStore& store, const SweepOptions& options) {
  if (store.stands()) {
    if (!options.resume && options.shard.empty())
      throw InputError(
          fmt::format("{} holds designs of a study that has not ended", store.folder().string()),
          "--resume goes on with it; else remove the folder");
    store.require_same();
  }
  store.begin();
}

int sweep(const SweepOptions& options, const Shard& shard, Ranks& ranks) {
  const Study study = read_study(options.study);
  require_designs(study);
  const std::string folder = options.out.empty() ? "reports/" + study.name : options.out;
  require_folder(folder);
  require_file_beside(options.json, folder);
  std::optional<Progress> progress(std::in_place, !options.quiet && ranks.is_first());
  progress->now("verifying the case as it is");
  const StudyDesigns designs(study);
  const Manifest manifest = manifest_of(study, designs, chunk_size(designs.size()));
  const bool has_ended = options.resume && stands_whole(manifest, folder);
  ranks.meet();  // all have looked before anything is written
  if (has_ended) {
    progress.reset();
    return ranks.is_first() ? say_again(manifest, folder, options) : all_pass;
  }
  const ChunkStore store(fs::path(folder) / "chunks", to_json(manifest));
  ranks.first_alone([&] { begin_store(store, options); });
  std::vector<std::size_t> todo;
  for (std::size_t chunk = shard.index; chunk < manifest.chunks(); chunk += shard.count)
    if (!store.read(chunk)) todo.push_back(chunk);
  ranks.meet();  // all have the same list before the first chunk of it is done
  Sweep(designs, manifest, store, std::move(todo), ranks).run(threads_of(options), *progress);
  progress.reset();  // its line is gone before the result is printed
  if (!ranks.is_first()) return all_pass;
  if (shard.count > 1) {
    put_text(layout::line(fmt::format("Part {} of {} is in {}; boxbeam merge joins all parts",
                                      shard.index + 1, shard.count, store.folder().string())));
    return all_pass;
  }
  const PublishedStudy published =
      publish_study(manifest, folder, options.netcdf, [&](std::size_t chunk) {
        std::optional<std::string> rows = store.read(chunk);
        if (!rows)
          throw OutputError(fmt::format("chunk {} in {} is not as it was written", chunk,
                                        store.folder().string()));
        return *std::move(rows);
      });
  store.remove();
  return say(published, folder, options.json);
}

}  // namespace

int run_sweep(const SweepOptions& options) {
  report::clear_up_before_the_end();
  const Shard shard = shard_in(options.shard);
  if (options.netcdf) require_column_files();
  Ranks ranks;
  try {
    return sweep(options, shard, ranks);
  } catch (const EndedElsewhere&) {
    return all_pass;  // the process that knows why says so, and its exit code counts
  }
}

int run_merge(const MergeOptions& options) {
  report::clear_up_before_the_end();
  const std::string folder = options.out.empty() ? options.folders.front() : options.out;
  if (options.netcdf) require_column_files();
  require_folder(folder);
  require_file_beside(options.json, folder);
  std::vector<ChunkStore> stores;
  for (const std::string& from : options.folders) {
    const std::optional<std::string> manifest = manifest_in(from);
    if (!manifest)
      throw InputError(fmt::format("{} holds no part of a study", from),
                       "give the folders that boxbeam sweep --shard has written to");
    if (!stores.empty() && stores.front().manifest() != *manifest)
      throw InputError(
          fmt::format("{} and {} hold parts of different studies", options.folders.front(), from),
          "run both with the same program, study and case");
    stores.emplace_back(fs::path(from) / "chunks", *manifest);
  }
  const Manifest manifest = manifest_in(stores.front().manifest(), options.folders.front());
  const auto rows_of = [&](std::size_t chunk) -> std::optional<std::string> {
    for (const ChunkStore& store : stores)
      if (std::optional<std::string> rows = store.read(chunk)) return rows;
    return std::nullopt;
  };
  std::size_t missing = 0, first = 0;  // designs, and their first chunk
  for (std::size_t chunk = manifest.chunks(); chunk-- > 0;) {
    if (rows_of(chunk)) continue;
    missing += manifest.rows_in(chunk);
    first = chunk;
  }
  if (missing > 0)
    throw InputError(fmt::format("{} of {} designs are missing, the first is design {}", missing,
                                 manifest.designs, first * manifest.chunk + 1),
                     "run boxbeam sweep for the other parts, and give all folders");
  const PublishedStudy published = publish_study(
      manifest, folder, options.netcdf, [&](std::size_t chunk) { return *rows_of(chunk); });
  for (const ChunkStore& store : stores) store.remove();
  return say(published, folder, options.json);
}

}  // namespace boxbeam::program
