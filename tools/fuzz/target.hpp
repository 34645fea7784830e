#pragma once

#include <cstddef>
#include <cstdint>

/// Called by libFuzzer with generated data; a fault shows as an abort or a sanitizer report.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
