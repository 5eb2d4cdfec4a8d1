/// The table of renderers.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "render/filtered.h"
#include "validate/renderers/adapter.h"
#include "validate/renderers/promise.h"

namespace lumaknot::validate {

/// How a renderer draws with random samples.
struct SamplingEntry {
  std::unique_ptr<Renderer> (*make)(const Programs& programs, const Sampling& sampling);
  PixelFilter filter;     ///< by which samples lie about a pixel's centre
  bool first_is_centred;  ///< the first sample of each pixel lies in its centre instead
};

/// All that is particular to a renderer.
struct RendererEntry {
  std::string_view name;  ///< in reports
  std::string_view flag;  ///< of `validate --renderer`
  /// Whether it draws when nobody asks for it. Left out are those that repeat another one's
  /// rasteriser, or are rarely installed.
  bool by_default = false;
  std::unique_ptr<Renderer> (*make)(const Programs& programs);
  std::array<const ProgramInfo*, 2> programs{};  ///< that it runs
  Promise promise;
  /// What another version promises; null: the same.
  Promise (*promise_of)(Promise promise, std::string_view version) = nullptr;
  const SamplingEntry* sampling = nullptr;  ///< null: it does not sample at random
};

/// All of them, in order.
std::span<const RendererEntry* const> renderer_entries();

/// The entry of the renderer called `name`. Throws std::logic_error if there is none.
const RendererEntry& renderer_entry(std::string_view name);

/// What the renderer promises in the version that it reports.
Promise promise_of(const RendererEntry& entry, std::string_view version);

/// The programs that renderers run, each once.
std::vector<const ProgramInfo*> renderer_programs();

}  // namespace lumaknot::validate
