#include "validate/self_test/self_test.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnose.h"
#include "render/reference.h"
#include "system/process.h"
#include "validate/compare/images.h"
#include "validate/compare/sensitivity.h"
#include "validate/renderers/entry.h"
#include "validate/self_test/setting_faults.h"

namespace lumaknot::validate {
namespace {

Shot final_of(const Scene& scene) { return {"final", Stage::kFinal, scene.view.material}; }

Image eight_bits(Image image) {
  for (RgbaPixel& p : image.pixels) {
    for (float* v : {&p.color.r, &p.color.g, &p.color.b}) {
      *v = std::round(std::clamp(*v, 0.0f, 1.0f) * 255) / 255;
    }
  }
  return image;
}

bool same(const Image& a, const Image& b) {
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (a.pixels[i].coverage != b.pixels[i].coverage) return false;
    if (largest_magnitude(to_vec(a.pixels[i].color) - to_vec(b.pixels[i].color)) > 1e-6) {
      return false;
    }
  }
  return true;
}

bool is_close(double value, double expected) {
  return std::abs(value - expected) <= std::max(1e-3, 0.01 * std::abs(expected));
}

bool has_numbers(const diagnosis::NamedCause& cause, const std::vector<PlantedNumber>& numbers) {
  return std::ranges::all_of(numbers, [&](const PlantedNumber& planted) {
    const auto found =
        std::ranges::find(cause.numbers, planted.name, &diagnosis::NamedNumber::name);
    return found != cause.numbers.end() && is_close(found->value, planted.value);
  });
}

/// `known`: causes that the renderer's unaltered picture has too.
bool is_right(const diagnosis::Explained& explained, const Fault& fault,
              const std::vector<std::string>& known) {
  std::vector<diagnosis::NamedCause> causes = explained.causes;
  std::erase_if(causes, [&](const diagnosis::NamedCause& cause) {
    return std::ranges::count(known, cause.id) > 0 &&
           std::ranges::count(fault.names, cause.id) == 0;
  });
  if (causes.size() != 1) return false;
  const diagnosis::NamedCause& cause = causes.front();
  if (cause.id == fault.names.front()) return has_numbers(cause, fault.numbers);
  return std::ranges::count(fault.names, cause.id) > 0;
}

bool is_right(const diagnosis::Diagnosis& d, const Fault& fault,
              const std::vector<std::string>& known) {
  const bool is_named = d.verdict == diagnosis::Diagnosis::Verdict::kNamed;
  if (fault.names.empty()) return d.verdict == diagnosis::Diagnosis::Verdict::kUnknown;
  const auto right = [&](const diagnosis::Explained& e) { return is_right(e, fault, known); };
  return is_named && (right(d.cause) || std::ranges::any_of(d.equivalents, right));
}

/// One self-test.
class Planting {
 public:
  explicit Planting(const SelfTestJob& job)
      : job_(job),
        shot_(final_of(job.scene)),
        fragments_(visible_fragments(job.scene)),
        reference_(job.scene, fragments_),
        sensitivities_(sensitivities(reference_, shot_)),
        own_(shade_all(job.scene, shot_, fragments_)),
        faults_(planted_faults(job.scene, knot())) {
    std::erase_if(faults_, [&](const Fault& f) {
      return !job.only.empty() && std::ranges::count(job.only, f.expected()) == 0;
    });
  }

  SelfTest run(const Progress& progress) {
    const double steps =
        double(2 * faults_.size() + 1 + job_.renderers.size() * (faults_.size() + 1) +
               setting_faults(job_.renderers).size());
    double step = 0;
    const auto report = [&] {
      check_interrupted();
      if (progress) progress(++step / steps);
    };
    unaltered("lumaknot", own_, false);
    unaltered("lumaknot", eight_bits(own_), true);
    report();
    for (const Fault& fault : faults_) {
      const Image picture = picture_with(fault);
      judge(fault, "lumaknot", picture, false), report();
      judge(fault, "lumaknot", eight_bits(picture), true), report();
    }
    for (const std::string& flag : job_.renderers) {
      drawn(nullptr, flag, job_.programs), report();
      for (const Fault& fault : faults_) {
        if (fault.scene) drawn(&fault, flag, job_.programs);
        report();
      }
      for (const SettingFault& setting : setting_faults({flag})) {
        const AlteredProgram altered(setting, job_.programs);
        drawn(&setting.fault, flag, altered.programs()), report();
      }
    }
    return std::move(test_);
  }

 private:
  const KnotSpec* knot() const { return job_.knot ? &*job_.knot : nullptr; }

  Scene scene_with(const Fault& fault) const {
    Scene scene = job_.scene;
    if (fault.scene) fault.scene(scene, knot());
    return scene;
  }

  Image picture_with(const Fault& fault) const {
    if (!fault.scene) return fault.picture(own_);
    const Scene scene = scene_with(fault);
    return shade_all(scene, final_of(scene), visible_fragments(scene));
  }

  static const RendererEntry& entry(const std::string& flag) {
    return **std::ranges::find(renderer_entries(), flag, &RendererEntry::flag);
  }

  /// Draws the scene with a fault, or without one, by another renderer.
  void drawn(const Fault* fault, const std::string& flag, const Programs& programs) {
    const RendererEntry& renderer = entry(flag);
    const Scene scene = fault ? scene_with(*fault) : job_.scene;
    const Shot shot = final_of(scene);
    Rendering rendering = renderer.make(programs)->draw(scene, {&shot, 1});
    RenderedShot& result = rendering.shots.front();
    const bool is_as_asked = result.status == RenderedShot::Status::kDrawn && !result.instead;
    const std::string name(renderer.name);
    test_.failed += result.status == RenderedShot::Status::kFailed;
    if (!is_as_asked) {
      test_.results.push_back({.fault = fault ? fault->what : "",
                               .drawn_by = name,
                               .expected = fault ? fault->expected() : "",
                               .why = result.why.empty() ? "drawn otherwise" : result.why});
    } else if (fault) {
      judge(*fault, name, result.image, rendering.limited);
    } else {
      unaltered(name, result.image, rendering.limited);
    }
  }

  Comparison compared(const std::string& renderer, const Image& picture, bool limited) const {
    // Our own pictures are held to the limits of the nearest relative, an emitted shader's.
    const RendererEntry& judged = renderer_entry(renderer == "lumaknot" ? "GL" : renderer);
    Standard standard;
    standard.limited = limited;
    standard.promise = promise_of(judged, {});
    // Those in 8 bits are our own; limited renderers promise their own steps.
    if (limited && renderer == "lumaknot")
      standard.promise.output_step = std::max(standard.promise.output_step, 1.0 / 255);
    return compare(reference_, shot_, own_, picture, sensitivities_, standard);
  }

  static bool is_noticed(const Comparison& c) {
    return c.outcome() != Outcome::kAgreed || c.coverage_unexplained > 0;
  }

  diagnosis::Diagnosis diagnosis_of(const Image& picture, bool limited) const {
    return diagnosis::diagnose({job_.scene, shot_, picture, job_.knot, limited, true});
  }

  static std::string ids(const diagnosis::Diagnosis& d) {
    std::vector<std::string> all;
    if (d.verdict != diagnosis::Diagnosis::Verdict::kNamed) return {};
    all.reserve(d.cause.causes.size());
    for (const diagnosis::NamedCause& cause : d.cause.causes) all.push_back(cause.id);
    return fmt::format("{}", fmt::join(all, " + "));
  }

  void unaltered(const std::string& renderer, const Image& picture, bool limited) {
    const diagnosis::Diagnosis d = diagnosis_of(picture, limited);
    const Comparison comparison = compared(renderer, picture, limited);
    known_ = classed_causes(comparison);
    const bool is_known = std::ranges::all_of(d.cause.causes, [&](const auto& cause) {
      return std::ranges::count(known_, cause.id) > 0;
    });
    const bool accused =
        is_noticed(comparison) || (d.verdict == diagnosis::Diagnosis::Verdict::kNamed && !is_known);
    ++test_.unaltered;
    test_.accused += accused;
    test_.results.push_back({.fault = {},
                             .drawn_by = renderer,
                             .values = limited ? "8 bits" : "float",
                             .noticed = accused,
                             .expected = {},
                             .named = ids(d),
                             .right = !accused,
                             .sentence = diagnosis::sentence_of(d)});
  }

  /// Whether our own picture shows the fault; of a renderer's settings it can't say, so yes.
  bool changes(const Fault& fault, bool limited) const {
    if (!fault.scene && !fault.picture) return true;
    const Image picture = picture_with(fault);
    return limited ? !same(eight_bits(picture), eight_bits(own_)) : !same(picture, own_);
  }

  void judge(const Fault& fault, const std::string& renderer, const Image& picture, bool limited) {
    PlantedResult result{.fault = fault.what,
                         .drawn_by = renderer,
                         .values = limited ? "8 bits" : "float",
                         .expected = fault.expected(),
                         .named = {},
                         .sentence = {}};
    ++test_.planted;
    const diagnosis::Diagnosis d = diagnosis_of(picture, limited);
    result.changes = changes(fault, limited);
    result.noticed = is_noticed(compared(renderer, picture, limited));
    result.named = ids(d);
    result.sentence = diagnosis::sentence_of(d);
    result.right = is_right(d, fault, known_);
    count(result);
    test_.results.push_back(std::move(result));
  }

  void count(const PlantedResult& result) {
    if (!result.changes) {
      ++test_.unseen;
      return;
    }
    test_.noticed += result.noticed;
    test_.right += result.right;
    test_.unknown += !result.right && result.named.empty();
    test_.wrong += !result.right && !result.named.empty();
  }

  const SelfTestJob& job_;
  Shot shot_;
  Grid<Fragment> fragments_;
  Reference reference_;
  Grid<Sensitivity> sensitivities_;
  Image own_;
  std::vector<Fault> faults_;
  std::vector<std::string> known_;  ///< causes of the present renderer's unaltered picture
  SelfTest test_;
};

}  // namespace

bool SelfTest::passed() const {
  constexpr double kNamed = 0.95;
  const long long seen = planted - unseen;
  return noticed == seen && failed == 0 && wrong == 0 && accused == 0 &&
         double(right) >= kNamed * double(seen);
}

SelfTest run_self_test(const SelfTestJob& job, const Progress& progress) {
  return Planting(job).run(progress);
}

}  // namespace lumaknot::validate
