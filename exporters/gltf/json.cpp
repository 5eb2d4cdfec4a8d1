#include "exporters/gltf/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "exporters/gltf/schema.h"
#include "system/error.h"

namespace lumaknot::gltf {
namespace {

using Kind = GltfKind;
using Scalar = GltfScalar;
using Shape = GltfShape;
using Member = GltfMember;

/// Indices are kept as ints; sizes stay far enough below 2^64 that their sums can't overflow.
constexpr std::uint64_t kMaxIndex = std::numeric_limits<int>::max();
constexpr std::uint64_t kMaxSize = std::uint64_t(1) << 40;
constexpr std::uint64_t kMaxStride = 252;

bool is_component(std::uint64_t number) {
  return number >= kGltfByte && number <= kGltfFloat && number != 5124;  // which GL calls int
}

std::string shown(const Scalar& value) {
  if (value.is_number) return fmt::format("{}", value.number);
  return value.is_text ? quoted_gltf(value.text) : "something else";
}

/// The problem of a value that must be of `kind`; empty: none.
std::string problem_of(const Scalar& value, Kind kind) {
  const auto is_integer_to = [&](std::uint64_t max) {
    return value.is_unsigned && value.integer <= max;
  };
  switch (kind) {
    case Kind::kIndex:
      return is_integer_to(kMaxIndex) ? "" : "must be an integer from 0 to 2^31 - 1";
    case Kind::kSize:
      return is_integer_to(kMaxSize) ? "" : "must be an integer from 0 to 2^40";
    case Kind::kBoolean:
      return value.is_boolean ? "" : "must be true or false";
    case Kind::kText:
      return value.is_text ? "" : "must be a string";
    case Kind::kNumber:
      return value.is_number ? "" : "must be a number";
    case Kind::kStride:
      if (is_integer_to(kMaxStride) && value.integer % 4 == 0) return "";
      return fmt::format("must be a multiple of 4 up to {}, got {}", kMaxStride, shown(value));
    case Kind::kComponent:
      if (value.is_unsigned && is_component(value.integer)) return "";
      return fmt::format("must be 5120 to 5123, 5125 or 5126, got {}", shown(value));
    case Kind::kType:
      if (gltf_type_number(value.text) <= kGltfTypes.size()) return "";
      return fmt::format("must be SCALAR, VEC2 or the like, got {}", shown(value));
    case Kind::kRefused:
      return "is not read; export without sparse accessors";
    case Kind::kObject:
      return "must be an object";
    case Kind::kList:
      break;
  }
  return "must be a list";
}

/// Receives a JSON parser's events, and skips values without a shape, at any depth.
class ModelBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit ModelBuilder(std::string_view name) : name_(name) {}

  GltfModel take() { return std::move(model_); }

  bool null() override { return scalar({}); }
  bool boolean(bool value) override { return scalar({.is_boolean = true, .integer = value}); }
  bool number_integer(std::int64_t value) override {
    return scalar({.is_number = true, .number = double(value)});
  }
  bool number_unsigned(std::uint64_t value) override {
    return scalar(
        {.is_unsigned = true, .is_number = true, .integer = value, .number = double(value)});
  }
  bool number_float(double value, const std::string&) override {
    return scalar({.is_number = true, .number = value});
  }
  bool string(std::string& value) override { return scalar({.is_text = true, .text = value}); }
  bool binary(nlohmann::json::binary_t&) override { return scalar({}); }
  bool start_object(std::size_t) override { return open(Kind::kObject); }
  bool start_array(std::size_t) override { return open(Kind::kList); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& key) override {
    if (skipped_levels_ > 0) return true;
    Level& level = open_.back();
    const auto& members = level.shape->members;
    level.at = std::size_t(std::ranges::find(members, key, &Member::key) - members.begin());
    if (level.at == members.size()) return true;
    const std::uint32_t bit = 1u << level.at;
    if (level.seen & bit) fail("appears twice; export it again");
    level.seen |= bit;
    return true;
  }

  bool parse_error(std::size_t byte, const std::string&,
                   const nlohmann::json::exception&) override {
    fail_gltf(name_, fmt::format("byte {} of the text", byte),
              "is not JSON; is it a glTF file, whole?");
  }

 private:
  struct Level {
    const Shape* shape;
    std::size_t at = 0;      ///< the current member, or the index of a list's item
    std::size_t items = 0;   ///< of a list so far
    std::uint32_t seen = 0;  ///< a bit per member
  };

  bool scalar(const Scalar& value) {
    const Shape* shape = skipped_levels_ == 0 ? next_shape() : nullptr;
    if (!shape) return true;
    const std::string problem = problem_of(value, shape->kind);
    if (!problem.empty()) fail(problem);
    shape->put(model_, value);
    return true;
  }

  bool open(Kind kind) {
    const Shape* shape = skipped_levels_ == 0 ? next_shape() : nullptr;
    if (!shape) {
      ++skipped_levels_;
      return true;
    }
    if (shape->kind != kind) fail(problem_of({}, shape->kind));
    if (shape->begin) shape->begin(model_);
    open_.push_back({shape});
    return true;
  }

  bool close() {
    if (skipped_levels_ > 0) {
      --skipped_levels_;
      return true;
    }
    const Level level = open_.back();
    const auto& members = level.shape->members;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (!members[i].required || level.seen >> i & 1) continue;
      open_.back().at = i;
      fail("is missing; export the file again");
    }
    open_.pop_back();
    const std::size_t count = level.shape->count;
    if (count > 0 && level.items != count) fail(fmt::format("must be {} numbers", count));
    return true;
  }

  /// The shape required of the next value; nullptr: it is not read.
  const Shape* next_shape() {
    if (open_.empty()) return &gltf_root();
    Level& outer = open_.back();
    if (outer.shape->kind == Kind::kList) {
      outer.at = outer.items++;
      return outer.shape->item;
    }
    const auto& members = outer.shape->members;
    return outer.at < members.size() ? &members[outer.at].shape : nullptr;
  }

  /// Throws Error at the path of the current value.
  [[noreturn]] void fail(std::string_view problem) const {
    std::string path;
    for (const Level& level : open_) {
      if (level.shape->kind == Kind::kList) {
        path += fmt::format("[{}]", level.at);
      } else {
        path += fmt::format("{}{}", path.empty() ? "" : ".", level.shape->members[level.at].key);
      }
    }
    fail_gltf(name_, path, problem);
  }

  std::string_view name_;
  GltfModel model_;
  std::vector<Level> open_;
  std::size_t skipped_levels_ = 0;
};

}  // namespace

void fail_gltf(std::string_view name, std::string_view place, std::string_view problem) {
  throw Error(fmt::format("{}: {} {}", name, place.empty() ? "the document" : place, problem));
}

std::string quoted_gltf(std::string_view text) {
  constexpr std::size_t kMax = 60;
  return nlohmann::json(text.substr(0, kMax))
      .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

GltfModel gltf_model(std::string_view json, std::string_view name) {
  // An item takes two bytes, so all places fit in an int.
  if (json.size() > std::numeric_limits<std::uint32_t>::max()) {
    fail_gltf(name, "the text", "is longer than 4 GiB; export to .glb");
  }
  ModelBuilder builder(name);
  nlohmann::json::sax_parse(json, &builder);
  return builder.take();
}

}  // namespace lumaknot::gltf
