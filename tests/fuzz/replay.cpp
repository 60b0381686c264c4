// Tries each file of the folders that are named: the corpus, without a fuzzer.

#include "clip/file.h"
#include "fuzz/target.h"

#include <cstdio>

int main(int count, char** values) {
    long tried = 0;
    for (int i = 1; i < count; ++i) {
        for (const auto& entry : std::filesystem::directory_iterator(values[i])) {
            std::printf("%s\n", entry.path().c_str());
            const auto bytes = ropesim::read_file(entry.path());
            LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
            ++tried;
        }
    }
    std::printf("%ld inputs tried\n", tried);
    return tried > 0 ? 0 : 1;
}
