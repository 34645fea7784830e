#pragma once

namespace higherpair {

/// Functions as one set of overloads, for std::visit.
template <class... Fs>
struct Overload : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overload(Fs...) -> Overload<Fs...>;

}  // namespace higherpair
