#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/shared_arguments.h"
#include "cli/terminal.h"
#include "scene/atomic_file.h"
#include "scene/error.h"
#include "study/stability/atlas_report.h"
#include "study/stability/regions.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

struct StabilityFlags {
  std::vector<std::string> regions;
  std::string output;
  bool list = false, resume = false;
  Output out;
};

/// The regions that were asked for, all unless any were.
std::vector<Region> chosen(const std::vector<std::string>& names) {
  std::vector<Region> all = all_regions();
  for (const std::string& name : names) {
    if (std::ranges::find(all, name, &Region::name) != all.end()) continue;
    throw Error(
        fmt::format("there is no region \"{}\"; lumaknot stability --list names them", name));
  }
  if (names.empty()) return all;
  std::erase_if(all,
                [&](const Region& r) { return std::ranges::find(names, r.name) == names.end(); });
  return all;
}

void write_pages(const Atlas& atlas, const fs::path& folder) {
  write_file(folder / "atlas.json", atlas_json(atlas), "--output");
  write_file(folder / "index.html", atlas_html(atlas), "--output");
}

void write_pictures(const Entry& entry, const fs::path& folder) {
  fs::create_directories(folder / entry.name);
  for (const Picture& picture : entry.pictures) {
    write_file(folder / entry.name / picture.file, picture.png, "--output");
  }
}

/// What the folder holds. What can't be read, or is by another version, is an error, unless all of
/// it is measured anew.
Atlas kept(const StabilityFlags& flags) {
  const fs::path file = fs::path(flags.output) / "atlas.json";
  if (flags.output.empty() || !fs::exists(file)) return {};
  const bool all_anew = flags.regions.empty() && !flags.resume;
  try {
    return read_atlas(read_file(file, "--output"), flags.output, file.string());
  } catch (const Error&) {
    if (!all_anew) throw;
    return {};
  }
}

bool has(const Atlas& atlas, const Region& region) {
  return std::ranges::find(atlas.entries, region.name, &Entry::name) != atlas.entries.end();
}

/// Puts `entry` in the place of an older one of its name, or last.
void put(Atlas& atlas, Entry entry) {
  const auto old = std::ranges::find(atlas.entries, entry.name, &Entry::name);
  if (old == atlas.entries.end()) {
    atlas.entries.push_back(std::move(entry));
  } else {
    *old = std::move(entry);
  }
}

/// Examines `regions`, or with --resume what `atlas` lacks of them; pictures are written one region
/// after the other.
void examine_all(const std::vector<Region>& regions, const StabilityFlags& flags, Atlas& atlas) {
  const std::function<void(double)> bar = progress_bar(flags.out, "stability");
  const bool draws = !flags.output.empty();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (flags.resume && has(atlas, regions[i])) continue;
    Entry entry = examine(regions[i], {.pictures = draws}, [&](double share) {
      check_interrupted();
      if (bar) bar((double(i) + share) / double(regions.size()));
    });
    if (draws) write_pictures(entry, flags.output);
    put(atlas, std::move(entry));
  }
  const bool told = flags.resume && !atlas.energies.empty();
  if (flags.regions.empty() && !told) atlas.energies = energies();
  if (bar) bar(1);
}

/// Regions in the order of the program's list, whichever run examined them.
void sort_entries(Atlas& atlas) {
  const std::vector<Region> order = all_regions();
  std::ranges::stable_sort(atlas.entries, {}, [&](const Entry& e) {
    return std::ranges::find(order, e.name, &Region::name) - order.begin();
  });
}

void list_regions(const StabilityFlags& flags) {
  for (const Region& r : chosen(flags.regions)) fmt::print("{:<25} {}\n", r.name, r.method);
}

void run(const StabilityFlags& flags) {
  if (flags.list) return list_regions(flags);
  const std::vector<Region> regions = chosen(flags.regions);
  if (flags.resume && flags.output.empty()) throw Error("--resume needs --output, the folder");
  if (!flags.output.empty()) {
    std::error_code failed;
    fs::create_directories(flags.output, failed);
    if (failed) {
      throw Error(fmt::format("--output {}: {}; give a folder", flags.output, failed.message()));
    }
    check_writable(fs::path(flags.output) / "index.html", "--output");
  }
  Atlas atlas = kept(flags);
  try {
    examine_all(regions, flags, atlas);
  } catch (const Interrupted&) {
    sort_entries(atlas);
    if (flags.output.empty()) throw;
    write_pages(atlas, flags.output);
    const auto there =
        std::ranges::count_if(regions, [&](const Region& r) { return has(atlas, r); });
    fmt::print(stderr,
               "\nlumaknot: {} of {} regions are in {}; the same command with --resume goes on\n",
               there, regions.size(), flags.output);
    throw;
  }
  sort_entries(atlas);
  if (!flags.output.empty()) write_pages(atlas, flags.output);
  if (flags.out.json) fmt::print("{}", atlas_json(atlas));
  flags.out.say(atlas_text(atlas));
  if (flags.output.empty()) return;
  const std::size_t count = atlas.entries.size();
  flags.out.say(fmt::format("{} region{}; see {}", count, count == 1 ? "" : "s",
                            (fs::path(flags.output) / "index.html").string()));
}

std::vector<std::string> region_names() {
  std::vector<std::string> names;
  for (const Region& region : all_regions()) names.push_back(region.name);
  return names;
}

std::vector<Argument> stability_arguments(StabilityFlags& flags) {
  std::vector<Argument> all{
      {.names = "regions",
       .target = &flags.regions,
       .meaning = "names of regions to examine",
       .value = "REGION",
       .default_text = "all",
       .choices = region_names(),
       .checked = false},
      {.names = "-o,--output",
       .target = &flags.output,
       .meaning = "a folder for index.html, atlas.json and a folder of pictures per region (needs "
                  "gnuplot), added to what the folder holds",
       .value = kFolder,
       .default_text = "print the boundaries alone"},
      {.names = "--list", .target = &flags.list, .meaning = "only list the regions"},
      {.names = "--resume",
       .target = &flags.resume,
       .meaning = "skip what the folder of --output holds already, as after an interrupted run"}};
  append(all, output_arguments(flags.out));
  return all;
}

}  // namespace

Subcommand stability_command() {
  const auto flags = std::make_shared<StabilityFlags>();
  return {
      .name = "stability",
      .group = Group::kStudy,
      .about = "Find and draw where methods fail, with the reason and the remedy",
      .arguments = stability_arguments(*flags),
      .examples = {{"lumaknot stability -o atlas/"},
                   {"lumaknot stability --list"},
                   {"lumaknot stability frenet-inflection phong-cutoff"},
                   {"lumaknot stability frenet-inflection -o atlas/", "again, keeping the others"},
                   {"lumaknot stability -o atlas/ --resume"}},
      .run = [flags] {
        const InterruptGuard guard;
        run(*flags);
        return kExitAgreed;
      }};
}

}  // namespace lumaknot
