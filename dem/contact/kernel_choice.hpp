#pragma once

#include "dem/contact/kernel_of.hpp"
#include "dem/contact/laws.hpp"

#include <optional>

/// Finds the kernel of the named laws by walking the law lists. One source file a normal law and
/// number type instantiates it, so that they compile side by side.
namespace dem::sweep_detail {

template <class Law> bool answers_to(std::string const& name) {
  if constexpr (requires { Law::knows(name); })
    return Law::knows(name);
  else
    return Law::name == name;
}

template <class T, class Normal, class Cohesion, class Tangential, class... Rolling>
std::optional<ContactKernel<T>> with_rolling(ContactChoice const& choice, LawList<Rolling...>) {
  std::optional<ContactKernel<T>> found;
  ((answers_to<Rolling>(choice.rolling)
        ? void(found = kernel_of<ContactModel<Normal, Cohesion, Tangential, Rolling>, T>())
        : void()),
   ...);
  return found;
}

template <class T, class Normal, class Cohesion, class... Tangential>
std::optional<ContactKernel<T>> with_tangential(ContactChoice const& choice,
                                                LawList<Tangential...>) {
  std::optional<ContactKernel<T>> found;
  ((answers_to<Tangential>(choice.tangential)
        ? void(found = with_rolling<T, Normal, Cohesion, Tangential>(choice, RollingLaws{}))
        : void()),
   ...);
  return found;
}

template <class T, class Normal, class... Cohesion>
std::optional<ContactKernel<T>> with_cohesion(ContactChoice const& choice, LawList<Cohesion...>) {
  std::optional<ContactKernel<T>> found;
  ((answers_to<Cohesion>(choice.cohesion)
        ? void(found = with_tangential<T, Normal, Cohesion>(
                   choice, typename Partners<Normal>::Tangential{}))
        : void()),
   ...);
  return found;
}

/// The kernel with this normal law, or nothing if a partner is not among its own.
template <class T, class Normal>
std::optional<ContactKernel<T>> kernel_with(ContactChoice const& choice) {
  return with_cohesion<T, Normal>(choice, typename Partners<Normal>::Cohesion{});
}

#define PRESSCHECK_DECLARE_KERNEL(Normal)                                                          \
  extern template std::optional<ContactKernel<float>> kernel_with<float, Normal>(                  \
      ContactChoice const&);                                                                       \
  extern template std::optional<ContactKernel<double>> kernel_with<double, Normal>(                \
      ContactChoice const&);
PRESSCHECK_DECLARE_KERNEL(Hertz)
PRESSCHECK_DECLARE_KERNEL(Hooke)
PRESSCHECK_DECLARE_KERNEL(Jkr)
PRESSCHECK_DECLARE_KERNEL(ThorntonNing)
PRESSCHECK_DECLARE_KERNEL(Edinburgh)
#undef PRESSCHECK_DECLARE_KERNEL

} // namespace dem::sweep_detail
