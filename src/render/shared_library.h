#pragma once

namespace ropesim {

// A library loaded at run time. It stays loaded until the process ends: OpenGL drivers leave handlers
// behind that must not be unmapped.
class SharedLibrary {
  public:
    // Throws std::runtime_error with the loader's message where it cannot be loaded.
    explicit SharedLibrary(const char* name);

    // Sets `function` to the library's function of that name. Throws std::runtime_error where it has none.
    template <typename Function>
    void load(Function*& function, const char* name) const {
        function = reinterpret_cast<Function*>(address(name));
    }

  private:
    void* address(const char* name) const;

    void* handle_;
};

}  // namespace ropesim
