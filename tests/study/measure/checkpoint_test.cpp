// What a checkpoint keeps, and when it is stale.
#include "study/measure/checkpoint.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "system/atomic_file.h"
#include "system/error.h"
#include "system/process.h"

namespace lumaknot::measure {
namespace {

using Json = nlohmann::ordered_json;

class CheckpointFile : public ::testing::Test {
 protected:
  Checkpoint of(const std::string& scene, const std::string& program = "p") const {
    return {file, {{"scene", scene}, {"program", program}}};
  }
  LoadResult load(const std::string& scene, const std::string& program = "p") {
    return of(scene, program).load([this](const Json& json) { value = json.at("value"); });
  }

  PrivateFolder folder;
  std::filesystem::path file = folder.path() / "kept.json";
  int value = 0;
};

TEST_F(CheckpointFile, is_read_as_it_was_saved_with_its_keys_first) {
  of("s").save({{"value", 7}});
  EXPECT_EQ(read_file(file, "test"),
            "{\n  \"scene\": \"s\",\n  \"program\": \"p\",\n  \"value\": 7\n}\n");
  EXPECT_TRUE(load("s").loaded());
  EXPECT_EQ(value, 7);
}

TEST_F(CheckpointFile, that_is_missing_is_neither_loaded_nor_stale) {
  const LoadResult result = load("s");
  EXPECT_FALSE(result.loaded());
  EXPECT_FALSE(result.stale());
}

TEST_F(CheckpointFile, with_another_key_is_stale_and_not_read) {
  of("s").save({{"value", 7}});
  const LoadResult result = load("s", "q");
  EXPECT_TRUE(result.stale());
  EXPECT_EQ(result.field, "program");
  EXPECT_EQ(result.found, "p");
  EXPECT_EQ(value, 0);
}

TEST_F(CheckpointFile, that_is_cut_short_or_lacks_a_value_is_stale_without_a_field) {
  for (const char* text : {"{\"scene\": \"s\"", "{}", "[]", "{\"scene\": 1}",
                           "{\"scene\": \"s\", \"program\": \"p\"}"}) {
    write_file(file, text, "test");
    const LoadResult result = load("s");
    EXPECT_TRUE(result.stale()) << text;
    EXPECT_TRUE(result.field.empty()) << text;
    EXPECT_FALSE(result.found.empty()) << text;
  }
}

TEST_F(CheckpointFile, that_can_t_be_read_is_an_error) {
  std::filesystem::create_directories(file);
  EXPECT_THROW(load("s"), Error);
}

TEST_F(CheckpointFile, is_not_saved_before_the_interval_is_over) {
  of("s").save_at_intervals([] { return Json{{"value", 7}}; });
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace lumaknot::measure
