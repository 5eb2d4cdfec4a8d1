#include <fmt/format.h>

#include <cmath>

#include "study/bench/report.h"
#include "study/paper/reproduction.h"
#include "validate/report/page_kit.h"

namespace lumaknot::embedded {
std::string_view paper_template();
std::string_view paper_picture_template();
}  // namespace lumaknot::embedded

namespace lumaknot::paper {
namespace {

using Data = validate::PageData;

constexpr std::string_view kRulingClasses[] = {"holds", "part", "not", "none"};

std::string ruling_class(Ruling ruling) { return std::string(kRulingClasses[std::size_t(ruling)]); }

Data image_data(const FigureImage& image, const FigurePicture& picture) {
  Data data;
  data.set("renderer", image.renderer);
  data.set("alt", fmt::format("{}, by {}", picture.caption, image.renderer));
  data.set("drawn", !image.file.empty());
  data.set("absent", image.file.empty());
  data.set("why", image.why);
  data.set("file", image.file);
  data.set("url", validate::picture_url(image.png));
  data.set("theirs", !image.outcome.empty() && !image.file.empty());
  data.set("outcome", image.outcome);
  data.set("class", image.outcome == "agreed" ? "holds" : "not");
  data.set("mean", fmt::format("{:.2g}", image.mean));
  data.set("agree", fmt::format("{:.2f}", 100 * image.agree));
  data.set("note", image.note);
  data.set("has_note", !image.note.empty());
  return data;
}

Data picture_data(const FigurePicture& picture) {
  Data data;
  data.set("caption", picture.caption);
  data.set("images", validate::page_list(picture.images, [&](const FigureImage& image) {
             return image_data(image, picture);
           }));
  return data;
}

Data measure_data(const Measure& m) {
  Data data;
  data.set("what", m.what);
  data.set("value", value_text(m));
  data.set("bound", bound_text(m));
  data.set("mark", m.is_bound() ? (m.meets() ? "yes" : "no") : "");
  data.set("class", m.is_bound() ? (m.meets() ? "holds" : "not") : "dim");
  return data;
}

Data claim_data(const PaperClaim& claim) {
  Data data;
  const Ruling ruling = ruling_of(claim);
  data.set("name", claim.name);
  data.set("says", claim.says);
  data.set("how", claim.how);
  data.set("beyond", claim.beyond);
  data.set("has_beyond", !claim.beyond.empty());
  data.set("ruling", std::string(ruling_name(ruling)));
  data.set("class", ruling_class(ruling));
  data.set("measures", validate::page_list(claim.measures, measure_data));
  return data;
}

Data sections_data(const std::vector<PaperClaim>& claims) {
  Data sections(Data::type::list);
  for (std::size_t i = 0; i < kPaperSections.size(); ++i) {
    Data section, list(Data::type::list);
    for (const PaperClaim& claim : claims) {
      if (claim.section == i) list.push_back(claim_data(claim));
    }
    section.set("title", std::string(kPaperSections[i]));
    section.set("claims", list);
    sections.push_back(section);
  }
  return sections;
}

Data counts_data(const std::vector<PaperClaim>& claims) {
  Data list(Data::type::list);
  for (const Ruling ruling :
       {Ruling::kHolds, Ruling::kHoldsInPart, Ruling::kDoesNotHold, Ruling::kNotMeasurable}) {
    Data data;
    data.set("count", std::to_string(count_of(claims, ruling)));
    data.set("ruling", std::string(ruling_name(ruling)));
    data.set("class", ruling_class(ruling));
    list.push_back(data);
  }
  return list;
}

std::string rate_text(double rate) { return fmt::format("{:.{}f}", rate, rate < 100 ? 1 : 0); }

/// Percent with one decimal, and no "-0.0".
std::string cost_text(double share) {
  const double rounded = std::round(1000 * share) / 10;
  return fmt::format("{:.1f}", rounded == 0 ? 0 : rounded);
}

std::string samples_text(int samples) {
  return samples == 1 ? "none" : fmt::format("{}x", samples);
}

std::string spread_text(const measure::Spread& ms) {
  return fmt::format("{:.3g} to {:.3g}", ms.min, ms.max);
}

Data rate_data(const bench::RateRow& row, const bench::RateTable& table) {
  Data data;
  const auto& ms = row.milliseconds;
  data.set("name", row.renderer);
  data.set("threads", row.threads ? std::to_string(row.threads) : "");
  data.set("size", std::to_string(table.width));
  data.set("samples", samples_text(row.samples));
  data.set("classical", rate_text(1000 / ms[0].median));
  data.set("table1", rate_text(1000 / ms[2].median));
  data.set("cost", cost_text(row.costs[2]));
  data.set("yiq", rate_text(1000 / ms[1].median));
  data.set("yiq_cost", cost_text(row.costs[1]));
  data.set("spread", spread_text(ms[0]));
  data.set("table1_spread", spread_text(ms[2]));
  return data;
}

Data paper_rate_data(const bench::PaperRow& row) {
  Data data;
  data.set("name", std::string(row.machine));
  data.set("size", std::to_string(row.side));
  data.set("samples", samples_text(row.samples));
  data.set("classical", rate_text(row.classical));
  data.set("table1", rate_text(row.yiq));
  data.set("cost", cost_text(1 - row.yiq / row.classical));
  return data;
}

void set_table(const bench::RateTable& table, Data& page) {
  page.set("rows", validate::page_list(table.rows, [&](const bench::RateRow& row) {
             return rate_data(row, table);
           }));
  page.set("paper_rows", validate::page_list(bench::paper_rows(), paper_rate_data));
  page.set("missing_rates", validate::page_list(table.missing, [](const bench::MissingRates& m) {
             Data data;
             data.set("name", m.renderer);
             data.set("why", m.why);
             return data;
           }));
}

Data renderers_data(const std::vector<FigureRenderer>& renderers) {
  return validate::page_list(renderers, [](const FigureRenderer& r) {
    Data data;
    data.set("name", r.name);
    data.set("version", r.version);
    data.set("seconds", fmt::format("{:.1f}", r.seconds));
    data.set("drew", r.missing.empty());
    data.set("absent", !r.missing.empty());
    data.set("missing", r.missing);
    return data;
  });
}

/// Figure 1's pictures two by two: a light's picture in Phong and in YIQ side by side.
Data lights_data(const std::vector<FigurePicture>& pictures) {
  Data list(Data::type::list);
  for (std::size_t i = 0; i + 1 < pictures.size(); i += 2) {
    Data light, pair(Data::type::list);
    pair.push_back(picture_data(pictures[i]));
    pair.push_back(picture_data(pictures[i + 1]));
    light.set("pair", pair);
    list.push_back(light);
  }
  return list;
}

}  // namespace

std::string paper_html(const PaperResult& result) {
  Data page;
  page.set("side", std::to_string(result.side));
  page.set("picture", Data(kainjow::mustache::partial(
                          [] { return std::string(embedded::paper_picture_template()); })));
  page.set("count", std::to_string(result.claims.size()));
  page.set("counts", counts_data(result.claims));
  page.set("lights", lights_data(result.figures.figure1));
  page.set("figure2", validate::page_list(result.figures.figure2, picture_data));
  page.set("renderers", renderers_data(result.figures.renderers));
  page.set("sections", sections_data(result.claims));
  set_table(result.rates, page);
  return validate::render_page(embedded::paper_template(), std::move(page));
}

}  // namespace lumaknot::paper
