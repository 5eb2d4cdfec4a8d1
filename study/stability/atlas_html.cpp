#include <fmt/format.h>

#include <cmath>

#include "study/stability/atlas_report.h"
#include "validate/report/page_kit.h"

namespace lumaknot::embedded {
std::string_view atlas_template();
}  // namespace lumaknot::embedded

namespace lumaknot::stability {
namespace {

using Data = validate::PageData;

Data picture_data(const Picture& picture, const std::string& region) {
  Data data;
  if (!picture.caption.empty()) data.set("caption", picture.caption);
  data.set("alt", region + ": " + (picture.caption.empty() ? "chart" : picture.caption));
  data.set("class", picture.file.substr(0, picture.file.find('.')));
  data.set("url",
           validate::picture_url(picture.png, picture.file.ends_with(".svg") ? "svg+xml" : "png"));
  return data;
}

std::string shown_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "not finite";
}

Data also_data(const std::vector<AlsoMeasured>& also) {
  return validate::page_list(also, [](const AlsoMeasured& a) {
    Data row;
    row.set("name", a.name);
    row.set("holds", shown_number(a.holds));
    row.set("boundary", shown_number(a.last_holding) + " → " + shown_number(a.first_failing));
    row.set("fails", shown_number(a.fails));
    return row;
  });
}

Data entry_data(const Entry& e) {
  Data data;
  data.set("name", e.name);
  data.set("method", e.method);
  data.set("reason", e.reason);
  data.set("remedy", e.remedy);
  data.set("parameter", e.parameter);
  data.set("measured", e.measured);
  data.set("limit", fmt::format("{:.4g}", e.limit));
  data.set("boundary", boundary_text(e.boundary));
  if (const std::string again = again_text(e); !again.empty()) data.set("again", again);
  data.set("holds", fmt::format("{:.5g}", e.boundary.holds.error));
  data.set("fails", fmt::format("{:.5g}", e.boundary.fails.error));
  if (!e.guarded.empty()) data.set("worst", fmt::format("{:.3g}", e.guarded_worst));
  data.set("also", also_data(e.also));
  data.set("has_also", !e.also.empty());
  data.set("pictures", validate::page_list(e.pictures, [&](const Picture& picture) {
             return picture_data(picture, e.name);
           }));
  return data;
}

Data groups_data(const Atlas& atlas) {
  Data groups(Data::type::list), regions(Data::type::list);
  const auto close = [&](const std::string& name) {
    Data group;
    group.set("group", name);
    group.set("regions", regions);
    groups.push_back(group);
    regions = Data(Data::type::list);
  };
  for (std::size_t i = 0; i < atlas.entries.size(); ++i) {
    const Entry& e = atlas.entries[i];
    regions.push_back(entry_data(e));
    const bool last = i + 1 == atlas.entries.size() || atlas.entries[i + 1].group != e.group;
    if (last) close(e.group);
  }
  return groups;
}

Data energies_data(const std::vector<Energy>& energies) {
  return validate::page_list(energies, [](const Energy& e) {
    Data row;
    row.set("term", e.term);
    row.set("most", fmt::format("{:.4g}", e.max));
    row.set("at", e.at_degrees < 0 ? "every" : fmt::format("{:.0f}°", e.at_degrees));
    row.set("above",
            e.above_degrees < 0 ? "never" : fmt::format("from {:.0f}° on", e.above_degrees));
    row.set("class", e.above_degrees < 0 ? "holds" : "fails");
    return row;
  });
}

}  // namespace

std::string atlas_html(const Atlas& atlas) {
  Data page;
  page.set("count", std::to_string(atlas.entries.size()));
  page.set("groups", groups_data(atlas));
  page.set("energies", energies_data(atlas.energies));
  page.set("has_energies", !atlas.energies.empty());
  return validate::render_page(embedded::atlas_template(), std::move(page));
}

}  // namespace lumaknot::stability
