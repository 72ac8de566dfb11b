#pragma once

namespace vehicle::test {

/// Blocks taken from the free store so far by this program, operator new and malloc alike. Under a sanitizer, which
/// has an allocator of its own, only operator new is counted.
[[nodiscard]] long allocations();

}  // namespace vehicle::test
