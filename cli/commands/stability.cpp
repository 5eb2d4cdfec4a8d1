#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/command_table.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "study/stability/atlas_report.h"
#include "study/stability/regions.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "system/process.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

struct StabilityFlags {
  std::vector<std::string> regions;
  std::string output;
  bool list = false, resume = false;
  Output out;
};

/// The named regions, or all if none are named.
std::vector<stability::Region> chosen(const std::vector<std::string>& names) {
  std::vector<stability::Region> all = stability::all_regions();
  for (const std::string& name : names) {
    if (std::ranges::find(all, name, &stability::Region::name) != all.end()) continue;
    throw Error(fmt::format("unknown region \"{}\"; lumaknot stability --list lists them", name));
  }
  if (names.empty()) return all;
  std::erase_if(all, [&](const stability::Region& r) {
    return std::ranges::find(names, r.name) == names.end();
  });
  return all;
}

void write_pages(const stability::Atlas& atlas, const fs::path& folder) {
  write_file(folder / "atlas.json", stability::atlas_json(atlas), "--output");
  write_file(folder / "index.html", stability::atlas_html(atlas), "--output");
}

void write_pictures(const stability::Entry& entry, const fs::path& folder) {
  fs::create_directories(folder / entry.name);
  for (const stability::Picture& picture : entry.pictures) {
    write_file(folder / entry.name / picture.file, picture.png, "--output");
  }
}

/// The atlas in the folder, empty if absent. One that can't be read, or is from another version, is
/// an error unless everything is measured again.
stability::Atlas kept(const StabilityFlags& flags) {
  const fs::path file = fs::path(flags.output) / "atlas.json";
  if (flags.output.empty() || !fs::exists(file)) return {};
  const bool redo_all = flags.regions.empty() && !flags.resume;
  try {
    return stability::read_atlas(read_file(file, "--output"), flags.output, file.string());
  } catch (const Error&) {
    if (!redo_all) throw;
    return {};
  }
}

bool has(const stability::Atlas& atlas, const stability::Region& region) {
  return std::ranges::find(atlas.entries, region.name, &stability::Entry::name) !=
         atlas.entries.end();
}

/// Replaces the entry with the same name, or appends `entry`.
void put(stability::Atlas& atlas, stability::Entry entry) {
  const auto old = std::ranges::find(atlas.entries, entry.name, &stability::Entry::name);
  if (old == atlas.entries.end()) {
    atlas.entries.push_back(std::move(entry));
  } else {
    *old = std::move(entry);
  }
}

/// Examines `regions`, or with --resume those missing from `atlas`; pictures are written after each
/// region.
void examine_all(const std::vector<stability::Region>& regions, const StabilityFlags& flags,
                 stability::Atlas& atlas) {
  const std::function<void(double)> bar = progress_bar(flags.out, "stability");
  const bool draws = !flags.output.empty();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (flags.resume && has(atlas, regions[i])) continue;
    stability::Entry entry = stability::examine(regions[i], {.pictures = draws}, [&](double share) {
      check_interrupted();
      if (bar) bar((double(i) + share) / double(regions.size()));
    });
    if (draws) write_pictures(entry, flags.output);
    put(atlas, std::move(entry));
  }
  const bool has_energies = flags.resume && !atlas.energies.empty();
  if (flags.regions.empty() && !has_energies) atlas.energies = stability::energies();
  if (bar) bar(1);
}

/// Sorts the regions in the order of all_regions(), whichever run examined them.
void sort_entries(stability::Atlas& atlas) {
  const std::vector<stability::Region> order = stability::all_regions();
  std::ranges::stable_sort(atlas.entries, {}, [&](const stability::Entry& e) {
    return std::ranges::find(order, e.name, &stability::Region::name) - order.begin();
  });
}

void list_regions(const StabilityFlags& flags) {
  for (const stability::Region& r : chosen(flags.regions))
    fmt::print("{:<25} {}\n", r.name, r.method);
}

void run(const StabilityFlags& flags) {
  if (flags.list) return list_regions(flags);
  const std::vector<stability::Region> regions = chosen(flags.regions);
  if (flags.resume && flags.output.empty())
    throw Error("--resume needs --output, the folder to resume");
  if (!flags.output.empty()) {
    std::error_code failed;
    fs::create_directories(flags.output, failed);
    if (failed) {
      throw Error(fmt::format("--output {} can't be used as a folder: {}; choose another place",
                              flags.output, failed.message()));
    }
    check_writable(fs::path(flags.output) / "index.html", "--output");
  }
  stability::Atlas atlas = kept(flags);
  try {
    examine_all(regions, flags, atlas);
  } catch (const Interrupted&) {
    sort_entries(atlas);
    if (flags.output.empty()) throw;
    write_pages(atlas, flags.output);
    const auto done =
        std::ranges::count_if(regions, [&](const stability::Region& r) { return has(atlas, r); });
    fmt::print(
        stderr,
        "\nlumaknot: {} of {} regions are kept in {}; the same command with --resume continues\n",
        done, regions.size(), flags.output);
    throw;
  }
  sort_entries(atlas);
  if (!flags.output.empty()) write_pages(atlas, flags.output);
  if (flags.out.json) fmt::print("{}", stability::atlas_json(atlas));
  flags.out.say(stability::atlas_text(atlas));
  if (flags.output.empty()) return;
  const std::size_t count = atlas.entries.size();
  flags.out.say(fmt::format("{} region{}; see {}", count, count == 1 ? "" : "s",
                            (fs::path(flags.output) / "index.html").string()));
}

std::vector<std::string> region_names() {
  std::vector<std::string> names;
  for (const stability::Region& region : stability::all_regions()) names.push_back(region.name);
  return names;
}

std::vector<Argument> stability_arguments(StabilityFlags& flags) {
  std::vector<Argument> all{
      {.names = "regions",
       .target = &flags.regions,
       .meaning = "regions to examine",
       .value = "REGION",
       .default_text = "all",
       .choices = region_names(),
       .checked = false},
      {.names = "-o,--output",
       .target = &flags.output,
       .meaning = "folder for index.html, atlas.json and the pictures (needs gnuplot); regions "
                  "already there are kept",
       .value = kFolder,
       .default_text = "only print the boundaries"},
      {.names = "--list", .target = &flags.list, .meaning = "list the regions"},
      {.names = "--resume",
       .target = &flags.resume,
       .meaning = "skip regions that are already in the output folder, as after an interruption"}};
  append(all, output_arguments(flags.out));
  return all;
}

}  // namespace

Subcommand stability_command() {
  const auto flags = std::make_shared<StabilityFlags>();
  return {.name = "stability",
          .group = Group::kStudy,
          .about = "Find and draw where methods fail, with the reason and the remedy",
          .arguments = stability_arguments(*flags),
          .examples = {{"lumaknot stability -o atlas/"},
                       {"lumaknot stability --list"},
                       {"lumaknot stability frenet-inflection phong-cutoff"},
                       {"lumaknot stability frenet-inflection -o atlas/",
                        "measure again, keeping the others"},
                       {"lumaknot stability -o atlas/ --resume"}},
          .run = [flags] {
            const InterruptGuard guard;
            run(*flags);
            return kExitAgreed;
          }};
}

}  // namespace lumaknot::cli
