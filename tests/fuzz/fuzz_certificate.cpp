// The independent checker on arbitrary bytes. It never throws, and says either why not or what is proved.
#include "proofs/checker/checker.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const limes::checker::Result result = limes::checker::check({reinterpret_cast<const char*>(data), size});
  const bool says_why = !result.step.empty() && !result.reason.empty();
  if (result.valid ? result.statement.empty() || says_why : !result.statement.empty() || !says_why) std::abort();
  return 0;
}
