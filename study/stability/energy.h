/// How much of the arriving light a lighting model reflects.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "models/registry.h"

namespace lumaknot::stability {

/// One of the terms of a lighting model, its numbers bound, for a white light of intensity 1.
using Term = std::function<double(const Directions<double>&)>;

/// The reflected share of the light that comes in `incidence` radians off the normal, below a right
/// angle: the integral of term n.v over the hemisphere of eyes by pi n.l. A white Lambert surface
/// has 1. Midpoints, 160 x 160 over half the hemisphere: 1e-3 for the
/// terms here, 5e-3 where one is infinite at the horizon.
double reflected_share(const Term& term, double incidence);

/// The largest share that a term reflects, over incidences from 0 to 89 degrees.
struct Energy {
  std::string term;           ///< its name and numbers
  double max = 0;             ///< the share
  double at_degrees = 0;      ///< the incidence; negative: all are equal
  double above_degrees = -1;  ///< the incidence from which it is above 1; negative: never
};

/// The largest share that `term`, called `name`, reflects.
Energy energy_of(std::string name, const Term& term);

/// The models' diffuse terms, then their highlights, for the numbers that each lists. Terms that
/// read the same numbers stand side by side, number by number.
std::vector<Energy> energies();

}  // namespace lumaknot::stability
