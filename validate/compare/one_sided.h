/// How far two noisy pictures may be off on one side.
#pragma once

namespace lumaknot::validate {

/// The chance that two variables both exceed `deviations`, or both fall below minus that: normal
/// ones that are independent but for their common variance, of which 1 is an estimate with
/// `freedom` > 0 degrees of freedom, as in Student's t distribution.
double both_beyond(double deviations, double freedom);

/// The number of deviations beyond which both are with the chance `chance` in (0, 0.25].
double deviations_of(double chance, double freedom);

/// The same as a distance, for means of `samples` independent samples each, whatever their
/// distribution: of the deviation `spread`, at most `reach` from their mean. Bernstein's
/// inequality (Boucheron, Lugosi, Massart, Concentration Inequalities, 2013, theorem 2.10).
double bernstein_distance(double chance, double spread, double reach, double samples);

}  // namespace lumaknot::validate
