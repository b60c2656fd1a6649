// Runs a fuzz target over files and folders without libFuzzer: what was found once stays fixed, with every compiler. An input
// that takes longer than its share of time is a finding too.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  constexpr double seconds_per_input = 30;
  std::vector<std::filesystem::path> inputs;
  for (int k = 1; k < argc; ++k) {
    if (!std::filesystem::is_directory(argv[k])) {
      inputs.emplace_back(argv[k]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argv[k])) inputs.push_back(entry.path());
  }
  std::sort(inputs.begin(), inputs.end());
  bool slow = false;
  for (const std::filesystem::path& input : inputs) {
    std::ifstream stream(input, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    if (!stream) {
      std::cerr << "cannot read " << input << '\n';
      return 2;
    }
    std::cout << input.filename().string() << std::flush;  // named before it may crash
    const auto start = std::chrono::steady_clock::now();
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::cout << "  " << seconds << " s\n";
    slow = slow || seconds > seconds_per_input;
  }
  if (slow) std::cerr << "an input took longer than " << seconds_per_input << " s\n";
  if (inputs.empty()) std::cerr << "no inputs\n";
  return slow || inputs.empty() ? 1 : 0;
}
