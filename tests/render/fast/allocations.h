/// Counts the allocations of a test program.
#pragma once

namespace lumaknot::testing {

/// The calls of operator new until now, in all threads.
long allocations();

}  // namespace lumaknot::testing
