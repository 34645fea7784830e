#pragma once

#include <cstddef>
#include <cstdint>

/// What libFuzzer calls with made-up data; a fault of ours is an abort or a sanitizer's report.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
