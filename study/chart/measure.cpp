#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "exporters/image/file.h"
#include "render/exact/truth.h"
#include "study/chart/checkpoint.h"
#include "study/chart/external.h"
#include "study/chart/points.h"
#include "study/measure/empty_scene.h"
#include "study/measure/fingerprint.h"
#include "study/measure/frame_time.h"
#include "study/measure/method_bench.h"
#include "system/error.h"
#include "system/known.h"
#include "system/process.h"

namespace lumaknot::chart {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFlag = "--output";
constexpr int kSettling = 4;     // times the rounds, at most
constexpr int kMeshSamples = 8;  // per side, of the area truth of a mesh file
constexpr double kTruthEnd = 0.3, kErrorsEnd = 0.6, kOthersEnd = 0.75;  // of the progress

/// The exact pictures, by space and index of kTruthNames.
using Truths = std::map<std::pair<Space, std::size_t>, measure::SeenImage>;

bool covers_something(const Image& image) {
  return std::ranges::any_of(image.pixels, [](const RgbaPixel& p) { return p.coverage > 0; });
}

/// The scene's own grid in the first space, the method that `lumaknot bench` draws.
measure::Method baseline(const ChartJob& job) {
  measure::Method method{.space = job.spaces.front()};
  if (const auto* knot = std::get_if<KnotSpec>(&job.mesh)) {
    method.segments = knot->segments;
    method.sides = knot->sides;
  }
  return method;
}

/// The chart with nothing measured.
Chart empty_chart(const ChartJob& job) {
  Chart chart;
  chart.scene_key = measure::scene_key(job.scene, job.mesh);
  chart.program_key = measure::program_key();
  chart.width = job.scene.view.image.width;
  chart.height = job.scene.view.image.height;
  const bool exact = std::holds_alternative<KnotSpec>(job.mesh);
  chart.truth = exact ? "rays against the exact tube, in double; area to 1/1024 a pixel"
                      : fmt::format(
                            "the mesh itself in double, since a mesh file has no exact "
                            "surface; area by {0} x {0} samples",
                            kMeshSamples);
  const std::vector<measure::Method> methods =
      usual_methods(job.mesh, job.scene.texture, job.spaces);
  for (const measure::Method& method : methods) {
    chart.points.push_back({measure::method_name(method), method, method.space, {}, {}, {}, {}});
  }
  chart.baseline = measure::method_name(baseline(job));
  return chart;
}

/// The frames that all others are timed against.
measure::DrawFrame baseline_frame(const ChartJob& job) {
  const auto renderer =
      std::make_shared<measure::MethodRenderer>(baseline(job), job.scene, measure::kTimedThreads);
  return [renderer] { renderer->draw(); };
}

/// Measures a chart in its folder.
class ChartRun {
 public:
  ChartRun(const ChartJob& job, const fs::path& folder, const Progress& progress)
      : job_(job),
        folder_(folder),
        progress_(progress),
        chart_(empty_chart(job)),
        checkpoint_(folder / kChartFile, chart_keys(chart_)),
        bench_(job.scene, job.mesh, [&job] { return baseline_frame(job); }) {}

  Chart run(const std::function<void(const std::string&)>& on_message) {
    const Truths truths = make_truths(resume(on_message));
    measure_errors(truths);
    if (job_.others) measure_others(truths);
    measure_times();
    chart_.complete = true;
    keep();
    return chart_;
  }

 private:
  /// Takes over what the folder holds of this chart; returns whether it holds it. Writes nothing:
  /// a scene may cover no pixel.
  bool resume(const std::function<void(const std::string&)>& on_message) {
    const measure::LoadResult result =
        checkpoint_.load([&](const nlohmann::ordered_json& json) { take_over(chart_from(json)); });
    if (result.stale()) {
      on_message(fmt::format("{} {}: measured again", (folder_ / kChartFile).string(),
                             reason_to_start_again(result)));
    }
    return result.loaded();
  }

  /// Makes the folder this chart's: removes another's exact pictures.
  void claim_folder() {
    for (const auto& entry : fs::directory_iterator(folder_)) {
      if (is_truth_file(entry.path())) fs::remove(entry.path());
    }
    keep();
  }

  /// Copies the results of methods that are charted again, and those of other programs, whose names
  /// may differ.
  void take_over(const Chart& old) {
    for (const ChartPoint& point : old.points) {
      const auto known = std::ranges::find(chart_.points, point.name, &ChartPoint::name);
      if (known != chart_.points.end()) *known = point;
      const bool drawn = std::ranges::count(job_.spaces, point.space) > 0;
      if (!point.method && job_.others && drawn) chart_.points.push_back(point);
    }
    if (job_.others) chart_.missing = old.missing;
  }

  void keep() { checkpoint_.save(chart_values(chart_)); }

  void report(double begin, double end, double share) const {
    if (progress_) progress_(begin + (end - begin) * share);
  }

  Image draw_truth_image(Space space, bool area, const Progress& progress) const {
    Scene scene = job_.scene;
    scene.view.material = measure::true_material(scene.view.material, space);
    if (const auto* knot = std::get_if<KnotSpec>(&job_.mesh)) {
      exact::TruthOptions options;
      options.sampling = area ? exact::TruthSampling::kArea : exact::TruthSampling::kPoint;
      return exact::render_truth(scene, *knot, options, progress);
    }
    scene.view.image.samples = area ? kMeshSamples : 1;
    return render(scene, progress);
  }

  /// Reads the exact pictures of a chart that is resumed; draws those that are missing, and writes
  /// them once one of the first space covers a pixel.
  Truths make_truths(bool resumed) {
    const double count = double(kTruthNames.size() * job_.spaces.size());
    bool writes = resumed;
    std::vector<std::pair<fs::path, Image>> unwritten;
    Truths truths;
    for (const Space space : job_.spaces) {
      for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
        const fs::path file = truth_file(folder_, space, truth);
        std::optional<Image> image = resumed ? kept_truth(file) : std::nullopt;
        if (!image) {
          image = draw_truth_image(space, truth == 1, [&](double part) {
            check_interrupted();
            report(0, kTruthEnd, (double(truths.size()) + part) / count);
          });
          unwritten.emplace_back(file, *image);
        }
        if (!writes && covers_something(*image)) {
          claim_folder();
          writes = true;
        }
        if (writes) write_truths(unwritten);
        truths[{space, truth}] = measure::seen(std::move(*image));
      }
      if (!writes) throw Error(measure::kNothingSeen);
    }
    keep();
    return truths;
  }

  static void write_truths(std::vector<std::pair<fs::path, Image>>& unwritten) {
    for (const auto& [file, image] : unwritten) write_image(file, image, kFlag);
    unwritten.clear();
  }

  /// Nothing if it is missing or can't be read.
  std::optional<Image> kept_truth(const fs::path& file) const {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return std::nullopt;
    try {
      return read_image(file, chart_.width, chart_.height);
    } catch (const std::runtime_error&) {
      return std::nullopt;
    }
  }

  static void set_errors(ChartPoint& point, const Image& image, int samples, const Truths& truths) {
    const measure::SeenImage drawn = measure::seen(image);
    if (samples == 1) point.errors[0] = measure::errors_between(truths.at({point.space, 0}), drawn);
    point.errors[1] = measure::errors_between(truths.at({point.space, 1}), drawn);
  }

  void measure_errors(const Truths& truths) {
    for (std::size_t i = 0; i < chart_.points.size(); ++i) {
      ChartPoint& point = chart_.points[i];
      if (!point.method || point.errors[1]) continue;
      check_interrupted();
      set_errors(point, bench_.draw(*point.method), point.method->samples, truths);
      keep();
      report(kTruthEnd, kErrorsEnd, double(i + 1) / double(chart_.points.size()));
    }
  }

  void measure_others(const Truths& truths) {
    std::vector<std::unique_ptr<OtherProgram>> programs = other_programs();
    for (std::size_t i = 0; i < programs.size(); ++i) {
      check_interrupted();
      measure_other(*programs[i], truths);
      keep();
      report(kErrorsEnd, kOthersEnd, double(i + 1) / double(programs.size()));
    }
  }

  void measure_other(OtherProgram& program, const Truths& truths) {
    const auto is_its = [&](const auto& known) { return known.name.starts_with(program.name()); };
    if (std::ranges::any_of(chart_.points, is_its)) return;
    std::erase_if(chart_.missing, is_its);  // it may have been installed since
    OtherResult result = program.measure(job_.scene, job_.spaces, baseline(job_));
    for (OtherFrame& frame : result.frames) {
      ChartPoint point{frame.name, std::nullopt, frame.space,       frame.how,
                       {},         {},           frame.milliseconds};
      set_errors(point, frame.image, frame.samples, truths);
      chart_.points.push_back(std::move(point));
    }
    for (MissingPoint& missing : result.missing) chart_.missing.push_back(std::move(missing));
  }

  void measure_times() {
    const double steps = double(job_.rounds) * double(chart_.points.size());
    double done = 0;
    for (int round = 0; round < job_.rounds; ++round) {
      for (ChartPoint& point : chart_.points) {
        report(kOthersEnd, 1, ++done / steps);
        if (point.method && measure::needs_round(point.milliseconds, std::size_t(round)))
          time(point);
        check_interrupted();
      }
      keep();
    }
    settle();
  }

  /// More rounds for the points whose times decide a front.
  void settle() {
    const Metric& metric = *std::ranges::find(chart_metrics(), job_.metric, &Metric::name);
    for (int round = job_.rounds; round < kSettling * job_.rounds; ++round) {
      const std::vector<std::size_t> contested = contested_points(chart_, metric);
      bool any = false;
      for (const std::size_t i : contested) {
        ChartPoint& point = chart_.points[i];
        if (point.ratios.size() > std::size_t(round)) continue;
        time(point);
        any = true;
        check_interrupted();
      }
      if (!any) return;
      keep();
    }
  }

  void time(ChartPoint& point) {
    const measure::FrameRound round = bench_.time(known(point.method));
    point.ratios.push_back(round.ratio);
    point.milliseconds.push_back(round.milliseconds);
  }

  const ChartJob& job_;
  fs::path folder_;
  const Progress& progress_;
  Chart chart_;
  measure::Checkpoint checkpoint_;
  measure::MethodBench bench_;
};

}  // namespace

std::size_t finished_points(const Chart& chart) {
  return std::size_t(std::ranges::count_if(chart.points, [](const ChartPoint& point) {
    return point.errors[1] && !point.milliseconds.empty();
  }));
}

Chart measure_chart(const ChartJob& job, const fs::path& folder, const Progress& progress,
                    const std::function<void(const std::string&)>& on_message) {
  return ChartRun(job, folder, progress).run(on_message);
}

}  // namespace lumaknot::chart
