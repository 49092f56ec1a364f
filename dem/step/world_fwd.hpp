#pragma once

namespace dem {
struct World;
struct Tool;
} // namespace dem
