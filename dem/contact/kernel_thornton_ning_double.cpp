#include "dem/contact/kernel_choice.hpp"

namespace dem::sweep_detail {

template std::optional<ContactKernel<double>>
kernel_with<double, ThorntonNing>(ContactChoice const&);

} // namespace dem::sweep_detail
