// clip.json, as 'ropesim diff' reads it beside frames: what is wrong with it is said in one line of plain
// text.

#include "clip/file.h"
#include "clip/temporary_folder.h"
#include "diff/side.h"
#include "fuzz/target.h"

using namespace ropesim;

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const TemporaryFolder folder;
    write_file(folder.path() / "clip.json", std::span(bytes, size));
    Comparison comparison;
    comparison.expected = folder.path();
    comparison.folders = true;
    const Side found = side(comparison, Which::expected);
    if (!found.scene) require_plain(found.problem);
    return 0;
}
