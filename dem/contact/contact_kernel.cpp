#include "dem/contact/contact_kernel.hpp"

#include "dem/contact/kernel_choice.hpp"
#include "dem/expect.hpp"

namespace dem {

using namespace sweep_detail;

namespace {

template <class T, class... Normal>
std::optional<ContactKernel<T>> find_kernel(ContactChoice const& choice, LawList<Normal...>) {
  std::optional<ContactKernel<T>> found;
  ((Normal::name == choice.normal ? void(found = kernel_with<T, Normal>(choice)) : void()), ...);
  return found;
}

} // namespace

template <class T> ContactKernel<T> make_kernel(ContactChoice const& choice) {
  auto const found = find_kernel<T>(choice, NormalLaws{});
  VALIDATE(found,
           "Contact laws " + choice.normal + " + " + choice.cohesion + " + " + choice.tangential +
               " + " + choice.rolling +
               " are unknown together (known: hertz with none, sjkr, sjkr2, linear_reduced or "
               "linear_hertz_circle and frictionless or mindlin; hooke with the same cohesion and "
               "frictionless "
               "or hooke_spring; thornton_ning with none, sjkr2, linear_reduced or "
               "linear_hertz_circle, and "
               "edinburgh or jkr with none, and frictionless or mindlin; rolling none or "
               "constant_torque). "
               "Is a name misspelt?");
  VALIDATE(choice.friction_limit == "net" || choice.friction_limit == "elastic",
           "Friction limit = " + choice.friction_limit +
               ": unknown (known: net, elastic). Is the name misspelt?");
  return *found;
}

template ContactKernel<float> make_kernel<float>(ContactChoice const&);
template ContactKernel<double> make_kernel<double>(ContactChoice const&);

} // namespace dem
