// The cache of linked programs, with a driver that only counts.
#include "render/gl/program_cache.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>

#include "base/destroy_in_background.h"
#include "render/gl/gl.h"
#include "render/gl/gl_objects.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;
using render::ProgramStore;
using testing::IsEmpty;
using testing::SizeIs;

// A driver whose binaries are the texts of the shaders.
struct CountingDriver {
  static constexpr GLenum kFormat = 0x1234;
  static inline std::string renderer, version;
  static inline int compiled = 0;
  static inline bool takesBinaries = true;
  static inline std::string shader, binary;
  static inline GLint linked = 0, binaryBytes = 0;
  static inline std::string loaded;

  static std::shared_ptr<render::Gl> make() {
    auto gl = std::make_shared<render::Gl>();
    gl->software = false;
    gl->programFormats = 1;
    gl->GetString = [](GLenum name) {
      const std::string& text = name == GL_VERSION ? version : renderer;
      return reinterpret_cast<const GLubyte*>(text.c_str());
    };
    gl->GetIntegerv = [](GLenum name, GLint* value) {
      if (name == GL_PROGRAM_BINARY_FORMATS) *value = kFormat;
    };
    gl->GetError = []() -> GLenum { return GL_NO_ERROR; };
    gl->Enable = gl->Disable = [](GLenum) {};
    gl->CreateProgram = []() -> GLuint {
      linked = 0;
      binary.clear();
      return 1;
    };
    gl->CreateShader = [](GLenum) -> GLuint { return 2; };
    gl->ShaderSource = [](GLuint, GLsizei, const GLchar* const* text, const GLint*) { shader = *text; };
    gl->CompileShader = [](GLuint) {
      ++compiled;
      binary += shader;
    };
    gl->GetShaderiv = [](GLuint, GLenum, GLint* value) { *value = GL_TRUE; };
    gl->AttachShader = gl->DetachShader = [](GLuint, GLuint) {};
    gl->LinkProgram = [](GLuint) { linked = GL_TRUE; };
    gl->GetProgramiv = [](GLuint, GLenum name, GLint* value) {
      *value = name == GL_LINK_STATUS ? linked : binaryBytes < 0 ? 0 : static_cast<GLint>(binary.size());
    };
    gl->ProgramParameteri = [](GLuint, GLenum, GLint) {};
    gl->GetProgramBinary = [](GLuint, GLsizei most, GLsizei* length, GLenum* format, void* data) {
      *length = std::min(most, static_cast<GLsizei>(binary.size()));
      *format = kFormat;
      std::memcpy(data, binary.data(), static_cast<std::size_t>(*length));
    };
    gl->ProgramBinary = [](GLuint, GLenum, const void* data, GLsizei length) {
      loaded.assign(static_cast<const char*>(data), static_cast<std::size_t>(length));
      linked = takesBinaries ? GL_TRUE : GL_FALSE;
    };
    gl->DeleteProgram = gl->DeleteShader = [](GLuint) {};
    return gl;
  }
};

class ProgramCacheTest : public ::testing::Test {
 protected:
  void SetUp() override {
    CountingDriver::renderer = "A card";
    CountingDriver::version = "4.6.0 Driver 1";
    CountingDriver::takesBinaries = true;
    CountingDriver::binaryBytes = 0;
    CountingDriver::loaded.clear();
  }

  // How many of these programs are compiled by a start of the program.
  std::size_t start(const std::vector<std::string>& fragments = {"first", "second"}) {
    const auto gl = CountingDriver::make();
    gl->programs = std::make_shared<render::ProgramCache>(*gl, store_);
    CountingDriver::compiled = 0;
    for (const std::string& fragment : fragments) render::Program::ofTexts(gl, "vertex", fragment, "a test");
    const render::ProgramCounts& counts = gl->programs->counts();
    EXPECT_EQ(counts.compiled + counts.cached, fragments.size());
    EXPECT_EQ(static_cast<std::size_t>(CountingDriver::compiled), 2 * counts.compiled);
    EXPECT_TRUE(base::awaitDestroyed(10.0));
    return counts.compiled;
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(store_.folder, none)) found.push_back(entry.path());
    return found;
  }
  static std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
  }
  static void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
  }

  ProgramStore store_{.folder = temporaryFolder() / "programs", .version = "0.2.0"};
};

TEST_F(ProgramCacheTest, ASecondStartCompilesNothing) {
  EXPECT_EQ(start(), 2u);
  EXPECT_THAT(files(), SizeIs(2));
  EXPECT_EQ(render::storedPrograms(store_.folder).count, 2u);
  EXPECT_GT(render::storedPrograms(store_.folder).bytes, 100u);
  EXPECT_EQ(start(), 0u);
  EXPECT_EQ(start({"second", "third", "first"}), 1u);
  EXPECT_EQ(start({"first"}), 0u);
  EXPECT_EQ(CountingDriver::loaded, "vertexfirst");
}

TEST_F(ProgramCacheTest, OtherDriversTextsAndVersionsAreOthers) {
  start();
  CountingDriver::renderer = "Another card";
  EXPECT_EQ(start(), 2u);
  CountingDriver::renderer = "A card";
  CountingDriver::version = "4.6.0 Driver 2";
  EXPECT_EQ(start(), 2u);
  CountingDriver::version = "4.6.0 Driver 1";
  store_.version = "0.2.1";
  EXPECT_EQ(start(), 2u);
  store_.version = "0.2.0";
  EXPECT_EQ(start(), 0u);
  // Of a program with the name of another one's file.
  const std::vector<fs::path> all = files();
  const std::string first = contentOf(all[0]);
  for (const fs::path& file : all) write(file, first);
  EXPECT_GE(start(), 1u);
  EXPECT_EQ(start(), 0u);
}

TEST_F(ProgramCacheTest, ADamagedFileIsIgnoredAndReplaced) {
  start({"first"});
  const fs::path file = files().at(0);
  const std::string whole = contentOf(file);
  const auto expectReplaced = [&](const std::string& words) {
    EXPECT_EQ(start({"first"}), 1u) << words;
    EXPECT_EQ(contentOf(file), whole) << words;
    EXPECT_EQ(start({"first"}), 0u) << words;
  };
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    write(file, damaged);
    CountingDriver::loaded.clear();
    ASSERT_EQ(start({"first"}), 1u) << "byte " << at;
    ASSERT_EQ(CountingDriver::loaded, "") << "byte " << at;
  }
  for (const std::size_t length : {std::size_t{0}, std::size_t{3}, whole.size() / 2, whole.size() - 1}) {
    write(file, whole.substr(0, length));
    expectReplaced("cut to " + std::to_string(length));
  }
  write(file, whole + "more");
  expectReplaced("longer");
  // What the driver does not take is compiled, too.
  CountingDriver::takesBinaries = false;
  EXPECT_EQ(start({"first"}), 1u);
  CountingDriver::takesBinaries = true;
  EXPECT_EQ(start({"first"}), 0u);
  // In place of the file there is something else.
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_EQ(start({"first"}), 1u);
}

TEST_F(ProgramCacheTest, WithoutAFolderEverythingIsCompiled) {
  store_.folder.clear();
  EXPECT_EQ(start(), 2u);
  EXPECT_EQ(start(), 2u);
  // A file where the folder would be: nobody can write there, not even root.
  const fs::path blocked = temporaryFolder() / "file";
  write(blocked, "text");
  store_.folder = blocked / "programs";
  EXPECT_EQ(start(), 2u);
  EXPECT_EQ(start(), 2u);
  EXPECT_EQ(contentOf(blocked), "text");
  store_.folder = "/proc/isolux/programs";
  EXPECT_EQ(start(), 2u);
}

TEST_F(ProgramCacheTest, DriversWithoutFormatsAndSoftwareStoreNothing) {
  const auto startWith = [&](auto change) {
    const auto gl = CountingDriver::make();
    change(*gl);
    gl->programs = std::make_shared<render::ProgramCache>(*gl, store_);
    render::Program::ofTexts(gl, "vertex", "first", "a test");
    EXPECT_TRUE(base::awaitDestroyed(10.0));
    return files().size();
  };
  EXPECT_EQ(startWith([](render::Gl& gl) { gl.programFormats = 0; }), 0u);
  EXPECT_EQ(startWith([](render::Gl& gl) { gl.software = true; }), 0u);
  EXPECT_EQ(startWith([](render::Gl&) { CountingDriver::binaryBytes = -1; }), 0u);
  CountingDriver::binaryBytes = 0;
  store_.software = true;
  EXPECT_EQ(startWith([](render::Gl& gl) { gl.software = true; }), 1u);
}

TEST_F(ProgramCacheTest, TheFolderIsLimitedAndTheOldestGo) {
  std::vector<std::string> fragments;
  for (int i = 0; i < 10; ++i) fragments.push_back(std::string(1000, static_cast<char>('a' + i)));
  store_.mostBytes = 8000;
  for (const std::string& fragment : fragments) start({fragment});
  EXPECT_LE(render::storedPrograms(store_.folder).bytes, store_.mostBytes);
  EXPECT_EQ(start({fragments[9]}), 0u);
  // Files of others stay.
  write(store_.folder / "notes.txt", std::string(20000, ' '));
  start({"another"});
  EXPECT_TRUE(fs::exists(store_.folder / "notes.txt"));
  // One that is used counts as new.
  const std::vector<fs::path> old = files();
  for (const fs::path& file : old)
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(100));
  EXPECT_EQ(start({fragments[9]}), 0u);
  for (int i = 0; i < 3; ++i) start({std::string(1000, static_cast<char>('p' + i))});
  EXPECT_FALSE(std::all_of(old.begin(), old.end(), [](const fs::path& file) { return fs::exists(file); }));
  EXPECT_EQ(start({fragments[9]}), 0u);
}

TEST_F(ProgramCacheTest, ProcessesMayShareTheFolder) {
  std::vector<std::string> fragments;
  for (int i = 0; i < 10; ++i) fragments.push_back("fragment " + std::to_string(i));
  // Another process: only files that are whole are seen.
  std::atomic<bool> ends{false};
  std::jthread other([&] {
    while (!ends) {
      for (const fs::path& file : files()) {
        const std::string text = contentOf(file);
        if (file.extension() == ".program" && !text.empty()) {
          EXPECT_TRUE(text.starts_with("ISOLUX PROGRAM"));
        }
        std::error_code gone;
        fs::remove(file, gone);
      }
    }
  });
  for (int i = 0; i < 5; ++i) start(fragments);
  ends = true;
  other.join();
  start(fragments);
  EXPECT_EQ(start(fragments), 0u);
}

TEST_F(ProgramCacheTest, TheStoreIsThatOfContextsMadeLater) {
  EXPECT_THAT(render::programStore().folder.string(), IsEmpty());
  render::setProgramStore(store_);
  EXPECT_EQ(render::programStore().folder, store_.folder);
  render::setProgramStore({});
}

}  // namespace
}  // namespace isolux::test
