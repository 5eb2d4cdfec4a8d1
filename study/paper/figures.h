/// The paper's figures, drawn by us and by other renderers.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "study/paper/scenes.h"
#include "validate/renderers/adapter.h"

namespace lumaknot::paper {

/// One renderer's picture; `image` of ours has no difference.
struct FigureImage {
  std::string renderer;
  std::string file;     ///< a PNG file's name below the page's folder; empty: it was not drawn
  std::string png;      ///< that file's bytes
  std::string outcome;  ///< "agreed", "differed", "failed" or "skipped"; empty: ours
  std::string why;      ///< if it was not drawn: the reason and the remedy
  std::string note;     ///< how it was drawn, if not simply by the renderer
  double mean = 0;      ///< of each pixel's largest difference of a channel, inside
  double agree = 0;     ///< share of the covered pixels that are covered in both and within limits
};

/// A renderer's picture, below the page's folder.
std::string figure_file(std::string_view picture, std::string_view renderer);

/// A picture of a figure.
struct FigurePicture {
  std::string name;                 ///< "front-phong"; letters, digits and '-'
  std::string caption;              ///< "Phong, light in front"
  std::vector<FigureImage> images;  ///< ours first
};

/// A renderer that was asked to draw.
struct FigureRenderer {
  std::string name;
  std::string version;  ///< empty if it never ran
  double seconds = 0;   ///< of its processes
  std::string missing;  ///< if it drew nothing: the reason and the remedy
};

/// The pictures of one light, each renderer's from one process.
struct LightPictures {
  std::vector<FigurePicture> pictures;
  std::vector<FigureRenderer> renderers;

  /// Whether every renderer drew every picture.
  bool complete() const;
};

/// The light in front, including specular reflection only; and the light at the back.
enum class FigureLight { kFront, kBack };

/// Draws with us, Cycles and POV-Ray, both at the same time, and compares as `lumaknot validate`
/// does. `on_message` is called when one of them is done. Throws Interrupted.
LightPictures draw_light(const PaperScenes& scenes, FigureLight light,
                         const validate::Programs& programs,
                         const std::function<void()>& on_message = {});

struct Figures {
  std::vector<FigurePicture> figure1;  ///< front, back, specular: each in Phong, then in YIQ
  std::vector<FigurePicture> figure2;  ///< Phong, YIQ by eq. 6-8, YIQ as Table 1 lists it
  std::vector<FigureRenderer> renderers;
};

Figures figures_of(const LightPictures& front, const LightPictures& back);

}  // namespace lumaknot::paper
