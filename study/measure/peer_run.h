/// Other programs drawing the frames that we draw, timed frame by frame.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/shot.h"
#include "scene/spec.h"
#include "system/process.h"

namespace lumaknot::measure {

enum class Peer {
  kSoftwareGl,  ///< the emitted GLSL on Mesa's software driver; rasterises
  kHardwareGl,  ///< the emitted GLSL on a GPU
  kEmbree,      ///< primary rays; the formulas of shaders/
};

struct PeerOptions {
  int samples = 1;  ///< per pixel: coverage and depth on GL, whole rays in Embree
  int threads = 0;  ///< 0: one per core. A GPU's driver has its own
  bool cull_back_faces = false;
  bool trilinear = true;  ///< GL; Embree has no mipmaps
};

/// The result of one run.
struct PeerTimes {
  std::string renderer;                           ///< as it names itself
  int samples = 1;                                ///< as drawn: a driver may have fewer
  std::vector<std::vector<double>> milliseconds;  ///< per shot and frame
};

/// "llvmpipe", "GPU" or "Embree".
std::string_view peer_name(Peer peer);

/// Why `peer` can't be run here, with the remedy; empty if it can.
std::string missing_peer(Peer peer);

/// A peer's files in a folder of its own, written once and drawn repeatedly.
class PeerRun {
 public:
  /// Throws std::runtime_error or Error if the peer is not found or can't draw the shots.
  PeerRun(Peer peer, const Scene& scene, std::span<const Shot> shots, const PeerOptions& options);

  /// Starts the program; it draws each shot untimed, then times `frames` frames of each in turn.
  /// Throws std::runtime_error with the reason, or Interrupted.
  PeerTimes run(int frames) const;

  /// A frame of the shot called `name`.
  Image image(const std::string& name) const;

 private:
  PrivateFolder folder_;
  ImageSpec size_;
  Command command_;
};

}  // namespace lumaknot::measure
