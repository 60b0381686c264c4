#include "clip/file.h"

#include "clip/temporary_folder.h"

#include <gmock/gmock.h>

#include <sys/wait.h>
#include <unistd.h>

#include <thread>

namespace ropesim {
namespace {

using testing::HasSubstr;

std::size_t files_in(const std::filesystem::path& folder) {
    const std::filesystem::directory_iterator files(folder);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

std::string failure_of_writing(const std::filesystem::path& path) {
    try {
        write_file(path, std::string_view("new"), Place::named);
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

std::string text_of(const std::filesystem::path& path) {
    const auto bytes = read_file(path);
    return {bytes.begin(), bytes.end()};
}

TEST(WriteFile, ReplacesWhatWasThereAndLeavesNothingElse) {
    const TemporaryFolder folder;
    write_file(folder.path() / "a", std::string_view("old and long"));
    write_file(folder.path() / "a", std::string_view("new"));
    EXPECT_EQ(text_of(folder.path() / "a"), "new");
    EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteFile, SaysWhyItCannot) {
    const TemporaryFolder folder;
    EXPECT_THAT(failure_of_writing(folder.path() / "missing" / "a"), HasSubstr("No such file or directory"));
    std::filesystem::create_directory(folder.path() / "b");
    EXPECT_THAT(failure_of_writing(folder.path() / "b"), HasSubstr("Is a directory"));
    EXPECT_EQ(files_in(folder.path()), 1u) << "no temporary file is left";
}

TEST(NewFile, HoldsWhatWasAppendedInItsOrder) {
    const TemporaryFolder folder;
    NewFile file(folder.path() / "a");
    std::string expected;
    for (const std::size_t size : {1U, 65535U, 65536U, 65537U, 0U, 200000U, 5U}) {
        const std::string part(size, static_cast<char>('a' + size % 26));
        file.append(part);
        expected += part;
    }
    file.finish();
    EXPECT_EQ(text_of(folder.path() / "a"), expected);
}

TEST(CheckWritable, TakesWhatCanBeWrittenAndLeavesItAsItIs) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "b");
    write_file(folder.path() / "old", std::string_view("old"));
    ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
    for (const char* name : {"new", "old", "pipe"}) EXPECT_NO_THROW(check_writable(folder.path() / name));
    EXPECT_NO_THROW(check_writable("new"));
    EXPECT_NO_THROW(check_writable("-"));
    EXPECT_NO_THROW(check_writable("/dev/full"));
    EXPECT_EQ(text_of(folder.path() / "old"), "old");
    EXPECT_EQ(files_in(folder.path()), 3u);
    for (const std::string& name :
         {std::string("b"), std::string("none/a"), std::string("old/a"), std::string(300, 'x')})
        EXPECT_THROW(check_writable(folder.path() / name), std::runtime_error) << name;
}

TEST(WriteFile, SaysThatTheDiskIsFull) {
    EXPECT_THAT(failure_of_writing("/dev/full"),
                HasSubstr("/dev/full: cannot write: No space left on device"));
}

TEST(WriteFile, WritesIntoAPipe) {
    const TemporaryFolder folder;
    const std::filesystem::path pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::string read;
    std::thread reader([&] { read = text_of(pipe); });
    write_file(pipe, std::string_view("through"), Place::named);
    reader.join();
    EXPECT_EQ(read, "through");
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(WriteFile, ReplacesAPipeThatNobodyNamed) {
    const TemporaryFolder folder;
    const std::filesystem::path pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    write_file(pipe, std::string_view("new"));
    EXPECT_EQ(text_of(pipe), "new");
}

TEST(ReadFile, NamesTheFileThatIsNotThere) {
    const TemporaryFolder folder;
    try {
        read_file(folder.path() / "none");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("none: cannot open: No such file or directory"));
    }
}

TEST(ReadFile, RefusesWhatIsTooLargeBeforeItTakesTheMemory) {
    const TemporaryFolder folder;
    const std::filesystem::path sparse = folder.path() / "sparse";
    write_file(sparse, std::string_view("1"));
    std::filesystem::resize_file(sparse, largest_file + 1);
    const auto refused = [](const std::filesystem::path& path, std::uint64_t largest) {
        EXPECT_THAT([&] { read_file(path, largest); },
                    testing::ThrowsMessage<std::runtime_error>(HasSubstr("expected at most ")));
    };
    refused(sparse, largest_file);
    refused("/dev/zero", 1'000'000);
    EXPECT_EQ(read_file("/dev/null", 0).size(), 0u);
    std::filesystem::resize_file(sparse, 1000);
    EXPECT_EQ(read_file(sparse, 1000).size(), 1000u);
    refused(sparse, 999);
}

// The name that a process of this machine gives its temporary file, found by watching one that is at it.
std::string temporary_name(pid_t process) {
    std::string host(64, '\0');
    ::gethostname(host.data(), host.size());
    return ".ropesim-" + std::string(host.c_str()) + "-" + std::to_string(process) + ".tmp";
}

TEST(RemoveStaleTemporaries, RemovesThoseOfDeadProcessesOnly) {
    const TemporaryFolder folder;
    const pid_t dead = ::fork();
    if (dead == 0) ::_exit(0);
    ::waitpid(dead, nullptr, 0);
    for (const std::string& name : {temporary_name(dead), temporary_name(::getppid()),
                                    std::string(".ropesim-elsewhere-1.tmp"), std::string("mine.tmp")})
        write_file(folder.path() / name, std::string_view("half a frame"));
    remove_stale_temporaries(folder.path());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / temporary_name(dead)));
    EXPECT_EQ(files_in(folder.path()), 3u);
}

}  // namespace
}  // namespace ropesim
