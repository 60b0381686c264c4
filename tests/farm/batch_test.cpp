#include "farm/batch.h"

#include "clip/process.h"

#include <gmock/gmock.h>

namespace ropesim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const BatchJob array_job{"render", "Task I of 8 makes some frames.", true, {"exec true"}};

TEST(Batch, AsksForAnArrayOfAllShards) {
    const std::string script = batch_script(array_job, {8, "night", "1:30:00"});
    EXPECT_THAT(script, AllOf(StartsWith("#!/bin/bash\n#SBATCH "), HasSubstr("#SBATCH --array=0-7\n"),
                              HasSubstr("#SBATCH --partition=night\n"), HasSubstr("#SBATCH --time=1:30:00\n"),
                              HasSubstr("\nset -e\nexec true\n")));
    const std::string plain = batch_script({"gather", "All.", false, {"true"}}, {8, "", ""});
    EXPECT_THAT(plain,
                AllOf(Not(HasSubstr("--array")), Not(HasSubstr("--partition")), Not(HasSubstr("--time"))));
}

TEST(Batch, LetsEachJobWaitForTheOneBefore) {
    BatchJob careful = array_job;
    careful.after_success = true;
    const std::string text =
        dry_run({{"simulate", "First.", false, {"true"}}, careful, {"gather", "Last.", false, {"true"}}},
                {8, "", ""}, "batch");
    EXPECT_THAT(text, HasSubstr("==> batch/simulate.sh <==\n#!/bin/bash\n"));
    EXPECT_THAT(text,
                HasSubstr("\n$ sbatch --parsable simulate.sh\n"
                          "$ sbatch --parsable --dependency=afterok:<simulate> --kill-on-invalid-dep=yes "
                          "render.sh\n"
                          "$ sbatch --parsable --dependency=afterany:<render> --kill-on-invalid-dep=yes "
                          "gather.sh\n"));
}

TEST(Batch, MakesOneWordOfAnyText) {
    for (const std::string text : {"a b", "it's", "$HOME `x` \"y\" \\ *", "a;b"})
        EXPECT_EQ(run_program({"sh", "-c", "printf %s " + shell_word(text)}, "."), text);
}

}  // namespace
}  // namespace ropesim
