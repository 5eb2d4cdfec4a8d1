/// std::visit with one lambda per alternative.
#pragma once

namespace lumaknot {

/// Calls whichever of its functions accepts the argument.
template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;  // clang 14 doesn't deduce aggregates

}  // namespace lumaknot
