// What a frame costs: ours, by one process and by two; our pictures by libpng's defaults; and the same
// picture drawn and written by cairo and by OpenCV. Each is a process, or two, that has started, has made its
// first frame, and waits; they take turns, so that whatever slows the machine slows all alike. What the parts
// of ours cost, each alone: together they are the floor. And how long it takes to start.

#include "benchmarks/frame_makers.h"
#include "benchmarks/processor.h"
#include "clip/find_scene.h"
#include "clip/frames.h"
#include "clip/helpers.h"
#include "clip/picture.h"
#include "clip/process.h"
#include "clip/run.h"
#include "image/compact_png.h"
#include "image/png.h"
#include "render/context.h"
#include "render/framebuffer.h"
#include "render/rope_painter.h"
#include "render/shared_library.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace {

using namespace ropesim;

constexpr int rounds = 5;
constexpr double round_seconds = 0.12;  // at least

// Of a round: with two processes, so many that it does not matter which one waits at its end.
int least_frames(int processes) {
    return processes == 1 ? 2 : 20;
}

struct Case {
    std::string name;
    Scene scene;
    Positions motion;
};

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// So many processes, of which one hands frames to the others as in a clip. They make frames for a round
// whenever they are told to.
class Worker {
  public:
    Worker(const Case& of, FrameMaker maker, int processes, const std::filesystem::path& folder) {
        std::array<int, 2> to{}, from{};
        if (::pipe(to.data()) != 0 || ::pipe(from.data()) != 0)
            throw std::runtime_error("cannot make a pipe");
        std::fflush(nullptr);
        process_ = ::fork();
        if (process_ < 0) throw std::runtime_error("cannot start a process");
        if (process_ == 0) {
            ::close(to[1]);
            work(of, maker, processes, folder, to[0], from[1]);
        }
        ::close(to[0]);
        ::close(from[1]);
        to_ = to[1];
        from_ = from[0];
        result();
    }
    ~Worker() {
        const char stop = 0;  // closing the pipe does not end it: workers that began later hold its end, too
        (void)!::write(to_, &stop, 1);
        ::close(to_);
        ::close(from_);
        ::waitpid(process_, nullptr, 0);
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    // Frames per second in a round.
    double round() const {
        const char go = 1;
        if (::write(to_, &go, 1) != 1) throw std::runtime_error("a process has ended");
        return result();
    }

  private:
    double result() const {
        double rate = 0.0;
        if (::read(from_, &rate, sizeof rate) != sizeof rate)
            throw std::runtime_error("a process has failed");
        return rate;
    }

    [[noreturn]] static void work(const Case& of, FrameMaker maker, int processes,
                                  const std::filesystem::path& folder, int from, int to) {
        try {
            make_rounds(of, maker, processes, folder, from, to);
            ::_exit(0);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "frames_benchmark: %s\n", error.what());
            ::_exit(1);
        }
    }

    static void make_rounds(const Case& of, FrameMaker maker, int processes,
                            const std::filesystem::path& folder, int from, int to) {
        const auto frames = static_cast<long>(of.motion.size());
        const std::string name = std::to_string(::getpid());
        MakeFrame make_frame;  // each process makes its own
        const auto draw = [&](long frame, const std::vector<Points>& positions) {
            if (!make_frame) make_frame = maker(of.scene);
            // Always a new file, as in a new clip.
            make_frame(frame % frames, positions, folder / (name + frame_name(frame, 1'000'000)));
        };
        Helpers helpers(processes - 1, of.motion.at(0), draw);
        long frame = 0;
        const auto make_next = [&] {
            const std::vector<Points>& positions = of.motion.at(frame % frames);
            if (!helpers.take(frame, positions, helpers.count())) draw(frame, positions);
            ++frame;
        };
        while (!make_frame) make_next();
        helpers.finish();
        double rate = 0.0;
        for (char go = 0;
             ::write(to, &rate, sizeof rate) == sizeof rate && ::read(from, &go, 1) == 1 && go == 1;) {
            const double begin = seconds();
            int made = 0;
            for (; made < least_frames(processes) || seconds() - begin < round_seconds; ++made) make_next();
            helpers.finish();
            rate = made / (seconds() - begin);
        }
    }

    pid_t process_ = 0;
    int to_ = -1;
    int from_ = -1;
};

struct Contestant {
    const char* name;
    FrameMaker maker;
    int processes;
    std::unique_ptr<Worker> worker;
    std::vector<double> rates;  // frames per second, one number a round

    double rate() {
        std::sort(rates.begin(), rates.end());
        return rates[rates.size() / 2];
    }
};

std::vector<Contestant> contestants() {
    std::vector<Contestant> all;
    all.push_back({"cairo", by_cairo, 1, {}, {}});
#if defined(ROPESIM_OPENCV)
    all.push_back({"OpenCV", by_opencv, 1, {}, {}});
#endif
    all.push_back({"ropesim's pictures by libpng", by_libpng, 1, {}, {}});
    all.push_back({"ropesim", by_ropesim, 1, {}, {}});
    all.push_back({"ropesim, two processes", by_ropesim, 2, {}, {}});
    return all;
}

void race(const Case& of, const std::filesystem::path& folder, const char* disk) {
    std::vector<Contestant> all = contestants();
    for (Contestant& each : all)
        each.worker = std::make_unique<Worker>(of, each.maker, each.processes, folder);
    for (int round = 0; round < rounds; ++round)
        for (Contestant& each : all) each.rates.push_back(each.worker->round());
    const double baseline = all.front().rate();
    std::printf("%s, to %s\n", of.name.c_str(), disk);
    for (Contestant& each : all)
        std::printf("    %-30s %9.3f ms %9.1f a second %7.1f x cairo\n", each.name, 1000.0 / each.rate(),
                    each.rate(), each.rate() / baseline);
    std::fflush(stdout);
}

void print_stages(const Case& of, const std::filesystem::path& folder, const char* disk) {
    std::vector<Stages> all;
    for (int round = 0; round < rounds; ++round) {
        // New files each time: to replace one takes longer.
        const std::filesystem::path own = folder / ("stages" + std::to_string(round));
        std::filesystem::create_directory(own);
        all.push_back(stages(of.scene, of.motion, own));
    }
    std::ranges::sort(all, {}, &Stages::sum);
    const Stages& median = all[all.size() / 2];
    std::printf("%s, to %s, one process; microseconds of each part alone:\n", of.name.c_str(), disk);
    std::printf("    clear %.0f, draw %.0f, read %.0f, filter %.0f, compress %.0f, write %.0f\n",
                median.clearing, median.drawing, median.reading, median.filtering, median.compressing,
                median.writing);
    std::printf("    together, the floor: %.0f; a whole frame: %.0f, %.2f x the floor\n", median.sum(),
                median.whole, median.whole / median.sum());
}

// Bytes of pixels in a file, on average over some frames.
void print_sizes(const Case& of) {
    constexpr long every = 20;
    double fast = 0.0, compact = 0.0, libpng = 0.0, count = 0.0;
    const std::unique_ptr<Renderer> renderer = make_renderer(of.scene);
    for (long frame = 0; frame < static_cast<long>(of.motion.size()); frame += every, ++count) {
        const Image& image = renderer->draw(polylines(of.scene, of.motion.at(frame)));
        fast += static_cast<double>(encode_png(image, {}).size());
        compact += static_cast<double>(encode_compact_png(image, {}).size());
        libpng += static_cast<double>(size_by_libpng(image));
    }
    std::printf("%s: %.1f KB a file, %.2f x libpng's; with --compact %.1f KB, %.2f x libpng's\n",
                of.name.c_str(), fast / count / 1000.0, fast / libpng, compact / count / 1000.0,
                compact / libpng);
}

// Milliseconds of the steps from an empty process to a first picture.
struct StartUp {
    double library = 0.0;        // loading OpenGL, and LLVM with it
    double context = 0.0;        // making it current, framebuffer included
    double shaders = 0.0;        // GLSL, as far as the driver compiles it beforehand
    double first_picture = 0.0;  // the driver makes machine code when it first draws

    double sum() const { return library + context + shaders + first_picture; }
};

// As a process that does nothing else prints them.
void print_own_start_up() {
    StartUp spent;
    double last = seconds();
    const auto take = [&last](double& milliseconds) {
        const double now = seconds();
        milliseconds = 1000.0 * (now - last);
        last = now;
    };
    const SharedLibrary library("libOSMesa.so.8");
    take(spent.library);
    const std::unique_ptr<OffscreenContext> context = make_context();
    const Gl gl = load_gl(*context);
    Framebuffer framebuffer(gl, 1280, 720);
    framebuffer.read({0, 0, 1, 1});
    take(spent.context);
    const RopePainter painter(gl, 1280, 720);
    take(spent.shaders);
    painter.paint({{{10.0F, 10.0F}, {90.0F, 20.0F}, 2.0F, {255, 0, 0, 0}}});
    framebuffer.read({0, 0, 1, 1});
    take(spent.first_picture);
    std::printf("%g %g %g %g", spent.library, spent.context, spent.shaders, spent.first_picture);
}

constexpr const char* own_start_up = "--start-up";  // the option by which this program prints it

StartUp start_up() {
    std::istringstream printed(run_program({"/proc/self/exe", own_start_up}, "/"));
    StartUp spent;
    if (!(printed >> spent.library >> spent.context >> spent.shaders >> spent.first_picture))
        throw std::runtime_error("no times of a start");
    return spent;
}

// Milliseconds from the program's start to its first frame in the folder.
double first_frame(const std::filesystem::path& folder) {
    const double begin = seconds();
    const pid_t child = ::fork();
    if (child == 0) {
        ::execl(ROPESIM_PROGRAM, "ropesim", "render", "--size", "1280x720", "--frames", "0:1", "--quiet",
                "--jobs", "1", "-o", folder.c_str(), nullptr);
        ::_exit(1);
    }
    while (!std::filesystem::exists(folder / "frame_0000.png")) {
        if (::waitpid(child, nullptr, WNOHANG) != 0) throw std::runtime_error("ropesim has failed");
        ::usleep(100);
    }
    const double spent = 1000.0 * (seconds() - begin);
    ::waitpid(child, nullptr, 0);
    std::filesystem::remove_all(folder);
    return spent;
}

void print_start_up(const std::filesystem::path& folder) {
    constexpr std::size_t times = 11;
    std::array<double, times> whole{};
    std::array<StartUp, times> parts;
    for (std::size_t i = 0; i < times; ++i) {
        whole[i] = first_frame(folder / "first");
        parts[i] = start_up();
    }
    std::ranges::sort(whole);
    std::ranges::sort(parts, {}, &StartUp::sum);
    const StartUp& median = parts[times / 2];
    std::printf("from the start of the program to the first frame: %.0f ms (fastest of %zu: %.0f)\n",
                whole[times / 2], times, whole.front());
    std::printf("    load OpenGL %.0f, make a context %.0f, compile shaders %.0f, first picture %.0f\n\n",
                median.library, median.context, median.shaders, median.first_picture);
}

Scene seed() {
    return parse_scene(builtin_scenes().front().toml, "seed");
}

Case make_case(std::string name, Scene scene, int width, int height, int frames) {
    scene.size = {width, height};
    scene.frames = frames;
    Case made{std::move(name), std::move(scene), {}};
    made.motion = positions(simulate(made.scene, runs(made.scene)), parse_frames("", frames));
    return made;
}

// Ropes that hang side by side from the upper half, and swing.
Scene many_ropes(int count, int masses) {
    Scene scene = seed();
    const SceneRope first = scene.ropes.front();
    scene.ropes.clear();
    for (int i = 0; i < count; ++i) {
        SceneRope rope = first;
        rope.name = "rope " + std::to_string(i);
        rope.nodes = masses;
        rope.start = {-400.0 + 800.0 * i / count, 200.0 + 100.0 * std::sin(i)};
        rope.end = rope.start + Eigen::Array2d(-300.0 * std::cos(0.7 * i), -100.0 * std::sin(0.3 * i));
        for (std::size_t channel = 0; channel < 3; ++channel)
            rope.color[channel] =
                static_cast<std::uint8_t>(55 + 37 * (i + 3 * static_cast<int>(channel)) % 200);
        scene.ropes.push_back(rope);
    }
    return scene;
}

std::vector<Case> cases() {
    std::vector<Case> all;
    all.push_back(make_case("1280 x 720, two ropes of 16", seed(), 1280, 720, 120));
    all.push_back(make_case("3840 x 2160, two ropes of 16", seed(), 3840, 2160, 120));
    all.push_back(make_case("320 x 240, two ropes of 16", seed(), 320, 240, 120));
    all.push_back(make_case("1280 x 720, 64 ropes of 64", many_ropes(64, 64), 1280, 720, 40));
    all.push_back(make_case("1280 x 720, 1000 ropes of 64", many_ropes(1000, 64), 1280, 720, 10));
    all.push_back(make_case("1280 x 720, a rope of 100,000", many_ropes(1, 100'000), 1280, 720, 10));
    all.push_back(
        make_case("1280 x 720, a rope that diverges", find_scene("explicit-euler").scene, 1280, 720, 60));
    return all;
}

void run(const std::filesystem::path& on_disk, const std::filesystem::path& in_memory) {
    std::printf("%s; one process is one core; medians of %d rounds\n\n", processor().c_str(), rounds);
    const std::vector<Case> all = cases();
    print_start_up(in_memory);  // first, while no OpenGL is loaded here
    print_stages(all.front(), in_memory, "memory");
    print_stages(all.front(), on_disk, "disk");
    print_sizes(all.front());
    for (const Case& each : all) race(each, in_memory, "memory");
    std::puts("(an ext4 without a journal makes files more slowly for minutes after many were deleted)");
    race(all.front(), on_disk, "disk");
}

}  // namespace

// Of two folders of its own, one is in the folder that is named, or in the usual one for temporary files.
int main(int count, char** values) {
    if (count > 1 && std::string_view(values[1]) == own_start_up) {
        print_own_start_up();
        return 0;
    }
    const std::filesystem::path folder = count > 1 ? values[1] : std::filesystem::temp_directory_path();
    const std::string name = "frames-benchmark-" + std::to_string(::getpid());
    const std::filesystem::path on_disk = folder / name;
    const std::filesystem::path in_memory = std::filesystem::path("/dev/shm") / name;
    int status = 0;
    try {
        std::filesystem::create_directories(on_disk);
        std::filesystem::create_directories(in_memory);
        run(on_disk, in_memory);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "frames_benchmark: %s\n", error.what());
        status = 1;
    }
    std::filesystem::remove_all(on_disk);
    std::filesystem::remove_all(in_memory);
    return status;
}
