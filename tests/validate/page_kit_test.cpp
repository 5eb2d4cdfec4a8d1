// What pages have in common.
#include "validate/report/page_kit.h"

#include <gmock/gmock.h>

namespace lumaknot::validate {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(PageKit, the_head_holds_the_shared_style_sheet) {
  const std::string page = render_page("{{> head}}<title>{{title}}</title>", [] {
    PageData data;
    data.set("title", "<one>");
    return data;
  }());
  EXPECT_THAT(page, StartsWith("<!DOCTYPE html>\n"));
  EXPECT_THAT(page, HasSubstr("<style>\n:root {"));
  EXPECT_THAT(page, HasSubstr("<title>&lt;one&gt;</title>"));
}

TEST(PageKit, a_figure_has_a_class_and_a_caption_if_they_are_set) {
  PageData data;
  data.set("url", picture_url("x"));
  data.set("alt", "a");
  EXPECT_EQ(render_page("{{> figure}}", data),
            "<figure><img alt=\"a\" src=\"data:image/png;base64,eA==\"></figure>\n");
  data.set("class", "c");
  data.set("caption", "d & e");
  const std::string figure = render_page("{{> figure}}", data);
  EXPECT_THAT(figure, StartsWith("<figure class=\"c\">"));
  EXPECT_THAT(figure, HasSubstr("<figcaption>d &amp; e</figcaption></figure>\n"));
}

TEST(PageKit, a_picture_is_a_url_that_needs_no_file) {
  EXPECT_THAT(picture_url("x", "svg+xml"), StartsWith("data:image/svg+xml;base64,"));
}

TEST(PageKit, a_list_has_a_row_for_each) {
  PageData page;
  page.set("numbers", page_list(std::vector{1, 2}, [](int i) {
             PageData row;
             row.set("i", std::to_string(i));
             return row;
           }));
  EXPECT_EQ(render_page("{{#numbers}}[{{i}}]{{/numbers}}", page), "[1][2]");
}

}  // namespace
}  // namespace lumaknot::validate
