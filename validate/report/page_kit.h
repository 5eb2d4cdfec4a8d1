/// What the HTML pages have in common.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <string_view>

namespace lumaknot::validate {

using PageData = kainjow::mustache::data;

/// A row for each of `all`.
template <class All, class Row>
PageData page_list(const All& all, const Row& row) {
  PageData list(PageData::type::list);
  for (const auto& one : all) list.push_back(row(one));
  return list;
}

/// A picture as a URL that needs no file; `type` is "png" or "svg+xml".
std::string picture_url(std::string_view bytes, std::string_view type = "png");

/// Fills `layout`. Its {{> head}} opens the page's head with the shared style sheet; {{> figure}}
/// is a picture with `url` and `alt`, and `class` and `caption` if they are set.
std::string render_page(std::string_view layout, PageData page);

}  // namespace lumaknot::validate
