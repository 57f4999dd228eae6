// Reads every #include of the tree: a layer may include only itself and what stands below it, Qt only ui/,
// GL headers only render/ and ui/, the libraries that parse other people's files only readers/, MPI one file;
// and which headers may hand on what takes long to compile.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::array<std::string_view, 7> layers{"base",   "scene", "volume", "gi",
                                                 "render", "app",   "ui"};  // lowest first

std::optional<std::size_t> layerOf(std::string_view path) {
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (path.starts_with(layers[i]) && path.substr(layers[i].size()).starts_with("/")) return i;
  return std::nullopt;
}

bool isQtHeader(const std::string& name) {
  static const std::regex qt(
      R"((Q[A-Z][A-Za-z0-9]*|qt[a-z]+-config\.h|q[a-z]+\.h)|(Qt[A-Z][A-Za-z0-9]*/.*))");
  return std::regex_match(name, qt);
}

bool isGlHeader(const std::string& name) {
  static const std::regex gl(R"((GL|GLES[0-9]*|EGL|KHR|epoxy|glbinding|glad)/.*|(gl|glew|glx)\.h)");
  return std::regex_match(name, gl);
}

// Of libraries that end the program on damaged files: they belong into the readers' processes.
bool isParserHeader(const std::string& name) {
  static const std::regex parser(
      R"(((vtk|H5)[A-Z]?[A-Za-z0-9]*\.h)|((hdf5|tiffio)\.h)|((OpenImageIO|gdcm)[A-Za-z0-9.-]*/.*))");
  return std::regex_match(name, parser);
}

bool isMpiHeader(const std::string& name) {
  static const std::regex mpi(R"((mpi|mpi-ext|mpi_portable_platform)\.h)");
  return std::regex_match(name, mpi);
}

bool isPythonHeader(const std::string& name) {
  return name.starts_with("pybind11/") || name.starts_with("numpy/") || name == "Python.h";
}

// The readers are programs of their own: they stand beside gi and may include what it may. The Python module
// stands beside ui and may include what is below that.
std::size_t rankOf(std::string_view path) {
  if (path.starts_with("readers/")) return layerOf("gi/").value();
  if (path.starts_with("python/")) return layerOf("app/").value();
  return layerOf(path).value();
}

// One line for each include of `path` (relative to the tree, inside a layer) that points the wrong way.
std::vector<std::string> wrongIncludes(const std::string& path, const std::string& content) {
  static const std::regex include(R"re(^\s*#\s*include\s*([<"])([^">]+)[">])re");
  const bool isReader = path.starts_with("readers/"), isPython = path.starts_with("python/");
  const std::size_t own = rankOf(path);
  std::vector<std::string> wrong;
  std::istringstream stream(content);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    std::smatch match;
    if (!std::regex_search(line, match, include)) continue;
    const std::string name = match[2];
    const auto complain = [&](const std::string& why) {
      wrong.push_back(path + ":" + std::to_string(number) + ": " + name + ": " + why);
    };
    const std::optional<std::size_t> target = layerOf(name);
    if (target && *target > own)
      complain(std::string(layers[own]) + " must not include " + std::string(layers[*target]));
    if (name.starts_with("gi/") && isReader) complain("readers must not include gi");
    if (name.starts_with("python/") && !isPython) complain("only the Python module includes python");
    if (name.starts_with("app/commands/") && isPython) complain("the command line is not for Python");
    if (isPythonHeader(name) && !isPython) complain("Python only in python");
    if (name.starts_with("readers/") && !isReader) complain("only readers include readers");
    if (isParserHeader(name) && !isReader) complain("parsers of other people's files only in readers");
    if (isMpiHeader(name) && path != "app/cluster/mpi_module.cpp")
      complain("MPI only in app/cluster/mpi_module.cpp");
    if (name.starts_with("tests/") || name.starts_with("bench/"))
      complain("the program must not include its tests");
    if (name.find("..") != std::string::npos) complain("include from the root of the tree");
    if (isQtHeader(name) && layers[own] != "ui") complain("Qt only in ui");
    if (isGlHeader(name) && layers[own] != "render" && layers[own] != "ui")
      complain("GL only in render and ui");
    if (match[1] == "\"" && !target && !name.starts_with("readers/") && !name.starts_with("python/") &&
        fs::path(name).has_parent_path())
      complain("no such layer");
  }
  return wrong;
}

bool isSource(const fs::path& path) {
  static const std::array<std::string_view, 5> extensions{".h", ".cpp", ".inc", ".hpp", ".mm"};
  const std::string extension = path.extension().string();
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

std::vector<std::string> includesOf(const std::string& content) {
  static const std::regex include(R"re(^\s*#\s*include\s*[<"]([^">]+)[">])re");
  std::vector<std::string> names;
  std::istringstream stream(content);
  for (std::string line; std::getline(stream, line);)
    if (std::smatch match; std::regex_search(line, match, include)) names.push_back(match[1]);
  return names;
}

// A library whose headers take seconds to compile: the headers of ours that may include it, so that sources
// get it where they use it.
struct SlowLibrary {
  std::string_view prefix;
  std::vector<std::string_view> headers;
};
const std::vector<SlowLibrary>& slowLibraries() {
  static const std::vector<SlowLibrary> list{
      {"tbb/", {"volume/field/filter_lines.h", "volume/cast/cell_bits_on_demand.h"}},
      {"nlohmann/json.hpp",
       {"scene/settings/scene_diff.h", "scene/settings/setting_value.h", "app/documents/stored_scene.h",
        "app/presets/preset.h"}},
      {"CLI/", {"app/commands/command.h", "app/commands/render_target.h"}},
      {"hwy/", {"-inl.h"}},
      {"Eigen/", {}},
  };
  return list;
}

// One line for each include of a header of ours that hands on what it should not.
std::vector<std::string> slowIncludes(const std::string& path, const std::string& content) {
  std::vector<std::string> wrong;
  if (!path.ends_with(".h")) return wrong;
  for (const std::string& name : includesOf(content))
    for (const SlowLibrary& library : slowLibraries()) {
      const bool mayHave = std::any_of(library.headers.begin(), library.headers.end(),
                                       [&](std::string_view header) { return path.ends_with(header); });
      if (name.starts_with(library.prefix) && !mayHave)
        wrong.push_back(path + ": " + name +
                        ": slow to compile; include it in sources (or a forward declaration)");
    }
  // Kernels and fields need what settings choose among, not all of the Scene.
  static const std::regex kernels(R"(volume/(cast|tracer|field|skip|hit)/.*)");
  static const std::array<std::string_view, 3> ofScenes{
      "volume/derived/cubic_fields.h", "volume/field/curvature.h", "volume/field/noise_gain.h"};
  if (std::regex_match(path, kernels) && std::find(ofScenes.begin(), ofScenes.end(), path) == ofScenes.end())
    for (const std::string& name : includesOf(content))
      if (name == "scene/scene.h") wrong.push_back(path + ": scene/scene.h: scene/choices.h has the choices");
  return wrong;
}

TEST(IncludeDirection, NoFileOfTheTreePointsTheWrongWay) {
  const fs::path root(ISOLUX_SOURCE_DIR);
  int files = 0;
  std::vector<std::string_view> folders(layers.begin(), layers.end());
  folders.emplace_back("readers");
  folders.emplace_back("python");
  for (const std::string_view layer : folders) {
    if (!fs::exists(root / layer)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / layer)) {
      if (!entry.is_regular_file() || !isSource(entry.path())) continue;
      std::ifstream stream(entry.path());
      std::stringstream content;
      content << stream.rdbuf();
      const std::string path = fs::relative(entry.path(), root).generic_string();
      EXPECT_THAT(wrongIncludes(path, content.str()), IsEmpty());
      EXPECT_THAT(slowIncludes(path, content.str()), IsEmpty());
      ++files;
    }
  }
  EXPECT_GT(files, 50) << "the test does not look where the sources are";
}

TEST(IncludeDirection, AcceptsWhatIsAllowed) {
  EXPECT_THAT(wrongIncludes(
                  "ui/window.cpp",
                  "#include <QWidget>\n#include \"ui/theme/theme.h\"\n#include \"app/documents/session.h\"\n"
                  "#include \"scene/scene.h\"\n#include <GL/gl.h>\n"),
              IsEmpty());
  EXPECT_THAT(wrongIncludes("render/gl/gl.h", "#include <GL/glcorearb.h>\n#include \"volume/grid.h\"\n"),
              IsEmpty());
  EXPECT_THAT(wrongIncludes("scene/scene.h", "#include <string>\n#include <glm/vec3.hpp>\n"), IsEmpty());
  EXPECT_THAT(
      wrongIncludes("readers/vtk/vti.cpp",
                    "#include <vtkNew.h>\n#include \"volume/grid.h\"\n#include \"readers/limits.h\"\n"),
      IsEmpty());
  EXPECT_THAT(wrongIncludes("python/core.h",
                            "#include <pybind11/numpy.h>\n#include \"app/options/scene_options.h\"\n#include "
                            "\"python/volume_thread.h\"\n"),
              IsEmpty());
  EXPECT_THAT(wrongIncludes("scene/scene.h", "// see #include \"ui/theme/theme.h\"\n"), IsEmpty());
  EXPECT_THAT(wrongIncludes("app/cluster/mpi_module.cpp", "#include <mpi.h>\n"), IsEmpty());
}

TEST(IncludeDirection, FindsHeadersThatHandOnWhatIsSlowToCompile) {
  for (const char* line : {"#include <tbb/parallel_for.h>", "#include <nlohmann/json.hpp>",
                           "#include <CLI/CLI.hpp>", "#include <hwy/highway.h>", "#include <Eigen/Dense>"}) {
    EXPECT_THAT(slowIncludes("app/a.h", line), ElementsAre(HasSubstr("slow to compile"))) << line;
    EXPECT_THAT(slowIncludes("app/a.cpp", line), IsEmpty()) << line;
  }
  EXPECT_THAT(slowIncludes("app/a.h", "#include <nlohmann/json_fwd.hpp>\n"), IsEmpty());
  EXPECT_THAT(slowIncludes("volume/cast/a-inl.h", "#include <hwy/highway.h>\n"), IsEmpty());
  EXPECT_THAT(slowIncludes("volume/field/filter_lines.h", "#include <tbb/combinable.h>\n"), IsEmpty());
  EXPECT_THAT(slowIncludes("volume/cast/a.h", "#include \"scene/scene.h\"\n"),
              ElementsAre(HasSubstr("scene/choices.h has")));
}

TEST(IncludeDirection, FindsEachKindOfFault) {
  EXPECT_THAT(wrongIncludes("scene/scene.h", "\n#include \"volume/grid.h\"\n"),
              ElementsAre("scene/scene.h:2: volume/grid.h: scene must not include volume"));
  for (std::size_t low = 0; low < layers.size(); ++low)
    for (std::size_t high = low + 1; high < layers.size(); ++high)
      EXPECT_THAT(wrongIncludes(std::string(layers[low]) + "/a.cpp",
                                "#include \"" + std::string(layers[high]) + "/b.h\""),
                  ElementsAre(HasSubstr("must not include")));
  for (const char* line : {"#include <QString>", "#  include <QtWidgets/QLabel>", " #include <qglobal.h>"})
    EXPECT_THAT(wrongIncludes("app/a.h", line), ElementsAre(HasSubstr("Qt only in ui"))) << line;
  for (const char* line : {"#include <GL/gl.h>", "#include <EGL/egl.h>", "#include <GL/osmesa.h>"})
    EXPECT_THAT(wrongIncludes("app/a.h", line), ElementsAre(HasSubstr("GL only"))) << line;
  for (const char* line :
       {"#include <vtkNew.h>", "#include <OpenImageIO/imageio.h>", "#include <gdcm-3.0/gdcmTag.h>"})
    EXPECT_THAT(wrongIncludes("volume/a.h", line), ElementsAre(HasSubstr("only in readers"))) << line;
  EXPECT_THAT(wrongIncludes("app/cluster/ranks.cpp", "#include <mpi.h>"),
              ElementsAre(HasSubstr("MPI only in")));
  EXPECT_THAT(wrongIncludes("volume/a.h", "#include \"readers/limits.h\""),
              ElementsAre(HasSubstr("only readers include readers")));
  EXPECT_THAT(wrongIncludes("python/core.h", "#include \"ui/theme/theme.h\""),
              ElementsAre(HasSubstr("must not include ui")));
  EXPECT_THAT(wrongIncludes("python/core.h", "#include \"app/commands/command.h\""),
              ElementsAre(HasSubstr("not for Python")));
  EXPECT_THAT(wrongIncludes("ui/a.h", "#include \"python/core.h\""),
              ElementsAre(HasSubstr("only the Python module")));
  EXPECT_THAT(wrongIncludes("app/a.h", "#include <pybind11/numpy.h>"),
              ElementsAre(HasSubstr("Python only in python")));
  EXPECT_THAT(wrongIncludes("readers/serve.h", "#include \"gi/sampling/environment.h\""),
              ElementsAre(HasSubstr("readers must not include gi")));
  EXPECT_THAT(wrongIncludes("app/a.h", "#include \"../ui/theme/theme.h\""),
              testing::Contains(HasSubstr("root")));
  EXPECT_THAT(wrongIncludes("app/a.h", "#include \"tests/support/test_data.h\""), testing::Not(IsEmpty()));
}

}  // namespace
}  // namespace isolux
