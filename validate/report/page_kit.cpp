#include "validate/report/page_kit.h"

#include <fmt/format.h>

#include "exporters/image/file.h"

namespace lumaknot::embedded {
std::string_view page_head();
std::string_view page_style();
std::string_view page_figure();
}  // namespace lumaknot::embedded

namespace lumaknot::validate {

std::string picture_url(std::string_view bytes, std::string_view type) {
  return fmt::format("data:image/{};base64,{}", type, base64(bytes));
}

std::string render_page(std::string_view layout, PageData page) {
  const auto add = [&](const char* name, std::string_view (*text)()) {
    page.set(name, PageData(kainjow::mustache::partial([text] { return std::string(text()); })));
  };
  add("head", embedded::page_head);
  add("style", embedded::page_style);
  add("figure", embedded::page_figure);
  return kainjow::mustache::mustache(std::string(layout)).render(page);
}

}  // namespace lumaknot::validate
