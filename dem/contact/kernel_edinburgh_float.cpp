#include "dem/contact/kernel_choice.hpp"

namespace dem::sweep_detail {

template std::optional<ContactKernel<float>> kernel_with<float, Edinburgh>(ContactChoice const&);

} // namespace dem::sweep_detail
