#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "exporters/image_file.h"
#include "meshgen/knot_mesh.h"
#include "render/truth.h"
#include "scene/atomic_file.h"
#include "scene/error.h"
#include "study/chart.h"
#include "study/chart_kept.h"
#include "study/chart_keys.h"
#include "study/chart_others.h"
#include "study/frame_time.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFlag = "--output";
constexpr int kSettling = 4;     // times the rounds, at most
constexpr int kMeshSamples = 8;  // a side, of the area truth of a mesh file
constexpr double kTruthEnd = 0.3, kErrorsEnd = 0.6, kOthersEnd = 0.75;  // of the progress

/// A chart being measured in its folder.
class Measuring {
 public:
  Measuring(const ChartJob& job, const fs::path& folder, const Progress& progress)
      : job_(job), folder_(folder), progress_(progress) {}

  Chart run(const std::function<void(const std::string&)>& told) {
    begin(told);
    make_truths();
    measure_errors();
    if (job_.others) measure_others();
    measure_times();
    chart_.complete = true;
    keep();
    return chart_;
  }

 private:
  /// Writes nothing: a scene may cover no pixel.
  void begin(const std::function<void(const std::string&)>& told) {
    chart_ = empty_chart();
    const KeptChart kept = kept_chart(folder_);
    const std::string why = reason_to_start_anew(kept, chart_.scene_key, chart_.program_key);
    claimed_ = why.empty();
    if (claimed_) {
      take_over(*kept.chart);
    } else if (kept.there) {
      told(fmt::format("{} {}: measured anew", (folder_ / kChartFile).string(), why));
    }
  }

  /// Makes the folder this chart's; what it holds of another goes.
  void claim_folder() {
    if (claimed_) return;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      if (is_truth_file(entry.path())) fs::remove(entry.path());
    }
    keep();
    claimed_ = true;
  }

  Chart empty_chart() const {
    Chart chart;
    chart.scene_key = scene_key(job_.scene, job_.mesh);
    chart.program_key = program_key();
    chart.width = job_.scene.view.image.width;
    chart.height = job_.scene.view.image.height;
    const bool exact = std::holds_alternative<KnotSpec>(job_.mesh);
    chart.truth = exact ? "rays against the exact tube, in double; area to 1/1024 a pixel"
                        : fmt::format(
                              "the mesh itself in double, since a mesh file has no exact "
                              "surface; area by {0} x {0} samples",
                              kMeshSamples);
    const std::vector<Method> methods = usual_methods(job_.mesh, job_.scene.texture, job_.spaces);
    for (const Method& method : methods) {
      chart.points.push_back({method_name(method), method, method.space, {}, {}, {}, {}});
    }
    chart.baseline = method_name(baseline());
    return chart;
  }

  /// The scene's own grid in the first space, the method that bench draws.
  Method baseline() const {
    Method method{.space = job_.spaces.front()};
    if (const auto* knot = std::get_if<KnotSpec>(&job_.mesh)) {
      method.segments = knot->segments;
      method.sides = knot->sides;
    }
    return method;
  }

  /// Results of methods that are charted again; those of other programs, whose names may differ.
  void take_over(const Chart& old) {
    for (const ChartPoint& point : old.points) {
      const auto known = std::ranges::find(chart_.points, point.name, &ChartPoint::name);
      if (known != chart_.points.end()) *known = point;
      const bool drawn = std::ranges::count(job_.spaces, point.space) > 0;
      if (!point.method && job_.others && drawn) chart_.points.push_back(point);
    }
    if (job_.others) chart_.missing = old.missing;
  }

  void keep() { write_file(folder_ / kChartFile, chart_json(chart_), kFlag); }

  void report(double begin, double end, double share) const {
    if (progress_) progress_(begin + (end - begin) * share);
  }

  Image draw_truth_image(Space space, bool area, const Progress& progress) const {
    Scene scene = job_.scene;
    scene.view.material = true_material(scene.view.material, space);
    if (const auto* knot = std::get_if<KnotSpec>(&job_.mesh)) {
      TruthOptions options;
      options.sampling = area ? TruthSampling::kArea : TruthSampling::kPoint;
      return render_truth(scene, *knot, options, progress);
    }
    scene.view.image.samples = area ? kMeshSamples : 1;
    return render(scene, progress);
  }

  void make_truths() {
    const double count = 2 * double(job_.spaces.size());
    int done = 0;
    for (const Space space : job_.spaces) {
      for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
        truths_[{space, truth}] = seen(make_truth(space, truth, done++ / count, 1 / count));
      }
      if (claimed_) continue;
      throw Error("the scene covers no pixel; move camera.position, or turn it to camera.target");
    }
    keep();
  }

  /// Read where the folder has it.
  Image make_truth(Space space, std::size_t truth, double begin, double share) {
    const fs::path file = truth_file(folder_, space, truth);
    if (const auto kept = kept_truth(file)) return *kept;
    Image image = draw_truth_image(space, truth == 1, [&](double part) {
      check_interrupted();
      report(0, kTruthEnd, begin + share * part);
    });
    unkept_.emplace_back(file, image);
    if (claimed_ || covers_something(image)) keep_truths();
    return image;
  }

  std::optional<Image> kept_truth(const fs::path& file) const {
    std::error_code ignored;
    if (!claimed_ || !fs::exists(file, ignored)) return std::nullopt;
    try {
      return read_image(file, chart_.width, chart_.height);
    } catch (const std::runtime_error&) {  // drawn again
      return std::nullopt;
    }
  }

  static bool covers_something(const Image& image) {
    return std::ranges::any_of(image.pixels, [](const RgbaPixel& p) { return p.coverage > 0; });
  }

  void keep_truths() {
    claim_folder();
    for (const auto& [file, image] : unkept_) write_image(file, image, kFlag);
    unkept_.clear();
  }

  /// The scene with the method's mesh, made once for each grid.
  const Scene& scene_of(const Method& method) {
    const std::pair grid{method.segments, method.sides};
    const auto known = scenes_.find(grid);
    if (known != scenes_.end()) return known->second;
    Scene scene = job_.scene;
    const MeshSpec mesh = method_mesh(method, job_.mesh);
    if (mesh_changed(mesh)) scene.mesh = knot_mesh(std::get<KnotSpec>(mesh));
    return scenes_.emplace(grid, std::move(scene)).first->second;
  }

  bool mesh_changed(const MeshSpec& mesh) const {
    const auto *made = std::get_if<KnotSpec>(&mesh), *own = std::get_if<KnotSpec>(&job_.mesh);
    return made && (made->segments != own->segments || made->sides != own->sides);
  }

  void judge(ChartPoint& point, const Image& image, int samples) {
    const SeenImage drawn = seen(image);
    if (samples == 1) point.errors[0] = errors_between(truths_[{point.space, 0}], drawn);
    point.errors[1] = errors_between(truths_[{point.space, 1}], drawn);
  }

  void measure_errors() {
    for (std::size_t i = 0; i < chart_.points.size(); ++i) {
      ChartPoint& point = chart_.points[i];
      if (!point.method || point.errors[1]) continue;
      check_interrupted();
      const Method method = *point.method;
      MethodRenderer renderer(method, scene_of(method));
      judge(point, renderer.image(), method.samples);
      keep();
      report(kTruthEnd, kErrorsEnd, double(i + 1) / double(chart_.points.size()));
    }
  }

  void measure_others() {
    std::vector<std::unique_ptr<OtherProgram>> programs = other_programs();
    for (std::size_t i = 0; i < programs.size(); ++i) {
      check_interrupted();
      measure_other(*programs[i]);
      keep();
      report(kErrorsEnd, kOthersEnd, double(i + 1) / double(programs.size()));
    }
  }

  void measure_other(OtherProgram& program) {
    const auto is_its = [&](const auto& known) { return known.name.starts_with(program.name()); };
    if (std::ranges::any_of(chart_.points, is_its)) return;
    std::erase_if(chart_.missing, is_its);  // it may have been installed since
    OtherResult result = program.measure(job_.scene, job_.spaces, baseline());
    for (OtherFrame& frame : result.frames) {
      ChartPoint point{frame.name, std::nullopt, frame.space,       frame.how,
                       {},         {},           frame.milliseconds};
      judge(point, frame.image, frame.samples);
      chart_.points.push_back(std::move(point));
    }
    for (MissingPoint& missing : result.missing) chart_.missing.push_back(std::move(missing));
  }

  void measure_times() {
    MethodRenderer beside(baseline(), scene_of(baseline()), kTimedThreads);
    beside.draw();  // the first frame takes the memory
    const double steps = double(job_.rounds) * double(chart_.points.size());
    double done = 0;
    for (int round = 0; round < job_.rounds; ++round) {
      for (ChartPoint& point : chart_.points) {
        report(kOthersEnd, 1, ++done / steps);
        if (point.method && needs_round(point, round)) time_round(point, beside);
        check_interrupted();
      }
      keep();
    }
    settle(beside);
  }

  /// More rounds for the points on whose times a front hangs.
  void settle(MethodRenderer& beside) {
    const Metric& metric = *std::ranges::find(chart_metrics(), job_.metric, &Metric::name);
    for (int round = job_.rounds; round < kSettling * job_.rounds; ++round) {
      const std::vector<std::size_t> contested = contested_points(chart_, metric);
      bool any = false;
      for (const std::size_t i : contested) {
        ChartPoint& point = chart_.points[i];
        if (point.ratios.size() > std::size_t(round)) continue;
        time_round(point, beside);
        any = true;
        check_interrupted();
      }
      if (!any) return;
      keep();
    }
  }

  /// A renderer made anew, since where its memory lies is part of its time.
  void time_round(ChartPoint& point, MethodRenderer& beside) {
    MethodRenderer renderer(*point.method, scene_of(*point.method), kTimedThreads);
    const FrameRound round = lumaknot::time_round([&] { renderer.draw(); }, [&] { beside.draw(); });
    point.ratios.push_back(round.ratio);
    point.milliseconds.push_back(round.milliseconds);
  }

  const ChartJob& job_;
  fs::path folder_;
  const Progress& progress_;
  Chart chart_;
  bool claimed_ = false;                            // the folder holds this chart
  std::vector<std::pair<fs::path, Image>> unkept_;  // until one of them covers a pixel
  std::map<std::pair<Space, std::size_t>, SeenImage> truths_;
  std::map<std::pair<int, int>, Scene> scenes_;
};

}  // namespace

std::size_t finished_points(const Chart& chart) {
  return std::size_t(std::ranges::count_if(chart.points, [](const ChartPoint& point) {
    return point.errors[1] && !point.milliseconds.empty();
  }));
}

Chart measure_chart(const ChartJob& job, const fs::path& folder, const Progress& progress,
                    const std::function<void(const std::string&)>& told) {
  return Measuring(job, folder, progress).run(told);
}

}  // namespace lumaknot
