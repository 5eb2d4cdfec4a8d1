#include <cmath>

#include "tests/study/paper/testing.h"

namespace lumaknot::paper {
namespace {

PaperClaim claim_of(std::vector<Measure> measures) {
  return {"name", 0, "says", "how", std::move(measures), ""};
}

const Measure kMet = at_most("met", 1, 2), kMissed = at_least("missed", 1, 2),
              kBeside = note("beside", 7);

TEST(PaperClaim, holds_when_every_bound_is_met) {
  EXPECT_EQ(ruling_of(claim_of({kMet, kBeside, kMet})), Ruling::kHolds);
}

TEST(PaperClaim, holds_in_part_when_some_bounds_are_met) {
  EXPECT_EQ(ruling_of(claim_of({kMet, kMissed})), Ruling::kHoldsInPart);
}

TEST(PaperClaim, does_not_hold_if_no_bound_is_met_whatever_the_notes) {
  EXPECT_EQ(ruling_of(claim_of({kMissed, kBeside})), Ruling::kDoesNotHold);
}

TEST(PaperClaim, is_not_measurable_without_a_bound) {
  EXPECT_EQ(ruling_of(claim_of({kBeside})), Ruling::kNotMeasurable);
}

TEST(PaperClaim, bounds_hold_at_their_ends_and_not_for_what_is_no_number) {
  EXPECT_TRUE(at_most("", 2, 2).meets());
  EXPECT_TRUE(at_least("", 2, 2).meets());
  EXPECT_TRUE(within("", 2, 2, 2).meets());
  EXPECT_FALSE(within("", 2.1, 1, 2).meets());
  EXPECT_FALSE(within("", 0.9, 1, 2).meets());
  EXPECT_FALSE(at_most("", std::nan(""), 2).meets());
}

TEST(PaperClaim, numbers_read_as_people_write_them) {
  EXPECT_EQ(figure_text(61440), "61,440");
  EXPECT_EQ(figure_text(-1234567), "-1,234,567");
  EXPECT_EQ(figure_text(12.345), "12.3");
  EXPECT_EQ(figure_text(1.5e-8), "1.5e-08");
  EXPECT_EQ(figure_text(1234.56), "1,235");
  EXPECT_EQ(value_text(note("", 3.2, "%")), "3.2 %");
  EXPECT_EQ(bound_text(within("", 0, 1, 2, "%")), "1 to 2 %");
  EXPECT_EQ(bound_text(within("", 0, 1, 1)), "1");
  EXPECT_EQ(bound_text(at_most("", 0, 5)), "at most 5");
  EXPECT_EQ(bound_text(kBeside), "");
}

}  // namespace
}  // namespace lumaknot::paper
