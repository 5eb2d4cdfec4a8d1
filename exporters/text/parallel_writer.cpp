#include "exporters/text/parallel_writer.h"

#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

namespace lumaknot {
namespace {

namespace tbb = oneapi::tbb;

constexpr std::size_t kChunkBytes = std::size_t{1} << 18;  // the size of a core's own cache
constexpr std::size_t kMaxChunks = 32;                     // in flight: 8 MiB

struct OutputChunk {
  std::unique_ptr<char[]> bytes;
  std::size_t size = 0;
};

std::size_t chunks_under_way(std::size_t chunks) {
  const auto threads = std::size_t(std::max(1, tbb::this_task_arena::max_concurrency()));
  return std::min({chunks, 2 * threads, kMaxChunks});
}

}  // namespace

void write_ranges(std::ostream& stream, std::size_t count, std::size_t item_bytes,
                  const RangeFormat& format) {
  const std::size_t items = std::max<std::size_t>(1, kChunkBytes / item_bytes);  // per chunk
  const std::size_t chunks = (count + items - 1) / items;
  if (chunks == 0) return;
  // Chunks are written in order, so the previous one in the same slot of the ring is done.
  std::vector<OutputChunk> ring(chunks_under_way(chunks));
  for (OutputChunk& chunk : ring)
    chunk.bytes = std::make_unique_for_overwrite<char[]>(items * item_bytes);
  std::size_t next = 0;
  std::atomic<bool> failed = false;
  const auto take = [&](tbb::flow_control& control) -> std::size_t {
    if (next == chunks || failed) control.stop();
    return next++;
  };
  const auto fill = [&](std::size_t index) {
    OutputChunk& chunk = ring[index % ring.size()];
    const std::size_t first = index * items, last = std::min(count, first + items);
    chunk.size = std::size_t(format(first, last, chunk.bytes.get()) - chunk.bytes.get());
    return index;
  };
  const auto drain = [&](std::size_t index) {
    const OutputChunk& chunk = ring[index % ring.size()];
    if (!stream.write(chunk.bytes.get(), std::streamsize(chunk.size))) failed = true;
  };
  tbb::parallel_pipeline(
      ring.size(),
      tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, take) &
          tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, fill) &
          tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, drain));
}

}  // namespace lumaknot
