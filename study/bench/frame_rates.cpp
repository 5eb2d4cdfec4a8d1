#include "study/bench/frame_rates.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <thread>
#include <tuple>

#include "render/fast/renderer.h"
#include "scene/presets.h"
#include "study/measure/peer_run.h"
#include "system/known.h"

namespace lumaknot::bench {
namespace {

constexpr int kFirstFrames = 3, kMaxFrames = 500;  // per shot and round of a peer

/// A row being measured.
struct Contender {
  RateRow row;
  std::function<FrameTimes(double seconds)> draw_round;
  std::vector<FrameTimes> rounds;
  std::string failed;  ///< why it stopped drawing
};

/// Our renderer with each shot's material, ready to draw.
class OwnFrames {
 public:
  OwnFrames(const Scene& scene, std::span<const Shot> shots, const fast::Options& options) {
    for (const Shot& shot : shots) {
      Scene with_material = scene;
      with_material.view.material = shot.material;
      renderers_.push_back(std::make_unique<fast::Renderer>(with_material, options));
      renderers_.back()->draw(image_);  // the first frame allocates the memory
    }
  }

  FrameTimes draw(double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto milliseconds = [](Clock::duration d) {
      return std::chrono::duration<double, std::milli>(d).count();
    };
    FrameTimes times;
    const auto start = Clock::now();
    do {
      for (std::size_t i = 0; i < renderers_.size(); ++i) {
        const auto before = Clock::now();
        renderers_[i]->draw(image_);
        times[i].push_back(milliseconds(Clock::now() - before));
      }
      check_interrupted();
    } while (milliseconds(Clock::now() - start) < seconds * 1000);
    return times;
  }

 private:
  std::vector<std::unique_ptr<fast::Renderer>> renderers_;
  Grid<fast::Rgba8> image_;
};

Contender own_contender(const Scene& scene, std::span<const Shot> shots, int threads, int samples) {
  fast::Options options;
  options.samples = samples;
  options.threads = threads;
  options.filter = Filter::kTrilinear;
  const auto frames = std::make_shared<OwnFrames>(scene, shots, options);
  Contender contender;
  contender.row.renderer = "lumaknot";
  contender.row.threads = threads;
  contender.row.samples = samples;
  contender.row.how = "trilinear";
  contender.draw_round = [frames](double seconds) { return frames->draw(seconds); };
  return contender;
}

std::string how_drawn(measure::Peer peer) {
  return peer == measure::Peer::kEmbree ? "bilinear, every ray shaded"
                                        : "trilinear, until glFinish, image in the driver's memory";
}

/// The number of frames that fill the time, from what frames took so far.
int frames_for(double seconds, const FrameTimes& last) {
  double milliseconds = 0;
  for (const std::vector<double>& shot : last) milliseconds += measure::median(shot);
  return int(std::clamp(seconds * 1000 / milliseconds, double(kFirstFrames), double(kMaxFrames)));
}

FrameTimes times_of(const measure::PeerTimes& peer) {
  FrameTimes times;
  if (peer.milliseconds.size() != times.size()) throw std::runtime_error("reported too few times");
  std::ranges::copy(peer.milliseconds, times.begin());
  return times;
}

/// Starts the peer once, so that its name and samples are known, and how long frames take.
Contender peer_contender(measure::Peer peer, const Scene& scene, std::span<const Shot> shots,
                         int threads, int samples) {
  const auto run = std::make_shared<measure::PeerRun>(
      peer, scene, shots, measure::PeerOptions{.samples = samples, .threads = threads});
  const measure::PeerTimes first = run->run(kFirstFrames);
  Contender contender;
  contender.row = {.renderer = first.renderer,
                   .threads = peer == measure::Peer::kHardwareGl ? 0 : threads,
                   .samples = first.samples,
                   .how = how_drawn(peer)};
  if (first.samples < samples) {
    contender.row.how += fmt::format(", {} samples at most", first.samples);
  }
  contender.draw_round = [run, last = times_of(first)](double seconds) mutable {
    last = times_of(run->run(frames_for(seconds, last)));
    return last;
  };
  return contender;
}

int thread_count(int wanted) {
  return wanted > 0 ? wanted : int(std::max(1u, std::thread::hardware_concurrency()));
}

/// One, and the number asked for.
std::vector<int> thread_counts(const RateOptions& options) {
  const int all = thread_count(options.threads);
  return all == 1 ? std::vector{1} : std::vector{1, all};
}

/// A driver that supports fewer samples than asked for would draw one row twice.
void add(Contender contender, std::vector<Contender>& all) {
  const RateRow& row = contender.row;
  const bool known = std::ranges::any_of(all, [&](const Contender& other) {
    return other.row.renderer == row.renderer && other.row.threads == row.threads &&
           other.row.samples == row.samples;
  });
  if (!known) all.push_back(std::move(contender));
}

void add_peer(measure::Peer peer, const Scene& scene, std::span<const Shot> shots,
              const RateOptions& options, std::vector<Contender>& contenders, RateTable& table) {
  try {
    if (const std::string why = measure::missing_peer(peer); !why.empty())
      throw std::runtime_error(why);
    std::vector<int> counts = thread_counts(options);
    if (peer == measure::Peer::kHardwareGl) counts = {0};
    for (const int threads : counts) {
      for (const int samples : options.samples) {
        add(peer_contender(peer, scene, shots, threads, samples), contenders);
      }
    }
  } catch (const std::runtime_error& e) {
    table.missing.push_back({std::string(measure::peer_name(peer)), e.what()});
  }
}

std::vector<Contender> all_contenders(const Scene& scene, const RateOptions& options,
                                      RateTable& table) {
  const std::vector<Shot> shots = rate_shots(scene);
  std::vector<Contender> contenders;
  for (const int threads : thread_counts(options)) {
    for (const int samples : options.samples) {
      add(own_contender(scene, shots, threads, samples), contenders);
    }
  }
  if (!options.peers) return contenders;
  for (const measure::Peer peer :
       {measure::Peer::kSoftwareGl, measure::Peer::kHardwareGl, measure::Peer::kEmbree}) {
    add_peer(peer, scene, shots, options, contenders, table);
  }
  return contenders;
}

void draw_round(Contender& contender, double seconds) {
  if (!contender.failed.empty()) return;
  try {
    contender.rounds.push_back(contender.draw_round(seconds));
  } catch (const std::runtime_error& e) {
    contender.failed = e.what();
  }
}

/// Its time over `ours`, from the medians of the classical frames of each round.
double ratio_of(const Contender& contender, const Contender& ours) {
  const auto medians = [](const Contender& of) {
    std::vector<double> all;
    all.reserve(of.rounds.size());
    for (const FrameTimes& round : of.rounds) all.push_back(measure::median(round[0]));
    return all;
  };
  return measure::paired_ratio(medians(contender), medians(ours));
}

/// Ours on as many threads (a GPU: on the most) and with as many samples, or the next higher number
/// there is, so that a row with fewer samples is not made to look slow.
const Contender& ours_beside(const Contender& contender, std::span<const Contender> all) {
  const RateRow& its = contender.row;
  const auto distance = [&](const Contender& ours) {
    const int threads =
        its.threads == 0 ? -ours.row.threads : std::abs(ours.row.threads - its.threads);
    return std::tuple(ours.row.renderer != all.front().row.renderer, threads,
                      ours.row.samples < its.samples, std::abs(ours.row.samples - its.samples));
  };
  return *std::ranges::min_element(all, {}, distance);
}

RateTable finished(std::vector<Contender>& contenders, RateTable table) {
  for (Contender& contender : contenders) {
    if (!contender.failed.empty()) {
      table.missing.push_back({contender.row.renderer, contender.failed});
      continue;
    }
    summarise(contender.rounds, contender.row);
    contender.row.ratio = ratio_of(contender, ours_beside(contender, contenders));
    table.rows.push_back(contender.row);
  }
  return table;
}

/// Rounds that disagree widen the interval of their frames alone.
Interval<double> cost_interval(std::span<const FrameTimes> rounds, std::size_t shot) {
  std::vector<double> costs, medians;
  for (const FrameTimes& round : rounds) {
    for (std::size_t i = 0; i < round[shot].size(); ++i) {
      costs.push_back(1 - round[0][i] / round[shot][i]);
    }
    medians.push_back(1 - measure::paired_ratio(round[0], round[shot]));
  }
  const auto [min, max] = std::ranges::minmax(medians);
  const Interval<double> frames = measure::median_interval(std::move(costs));
  return {std::min(frames.min, min), std::max(frames.max, max)};
}

}  // namespace

std::vector<Shot> rate_shots(const Scene& scene) {
  const Material& base = scene.view.material;
  std::vector<Shot> shots;
  for (const std::string_view formula : {"rgb-phong", "yiq-phong", "yiq-table1-phong"}) {
    const std::string name(kRateShots[shots.size()]);
    shots.push_back({name, Stage::kFinal, known(with_formula(base, formula))});
  }
  shots[1].material.form = Form::kCollapsed;
  return shots;
}

void summarise(std::span<const FrameTimes> rounds, RateRow& row) {
  FrameTimes all;
  for (const FrameTimes& round : rounds) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].insert(all[i].end(), round[i].begin(), round[i].end());
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    row.milliseconds[i] = measure::spread_of(all[i]);
    row.costs[i] = 1 - measure::paired_ratio(all[0], all[i]);
    row.cost_intervals[i] = cost_interval(rounds, i);
  }
}

RateTable measure_rates(const Scene& scene, const RateOptions& options, const Progress& progress) {
  RateTable table;
  table.width = scene.view.image.width;
  table.height = scene.view.image.height;
  std::vector<Contender> contenders = all_contenders(scene, options, table);
  const double steps = double(options.rounds) * double(contenders.size());
  int done = 0;
  for (int round = 0; round < options.rounds; ++round) {
    for (Contender& contender : contenders) {
      draw_round(contender, options.seconds);
      if (progress) progress(++done / steps);
    }
  }
  return finished(contenders, std::move(table));
}

}  // namespace lumaknot::bench
