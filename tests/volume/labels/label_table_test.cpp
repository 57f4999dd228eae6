#include "volume/labels/label_table.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace isolux::volume {
namespace {

TEST(LabelTables, ALayerHasItsLabelsInOrderEachOnce) {
  const LabelTable table{"its header lists segments",
                         "",
                         {{.value = 5, .name = "spleen"},
                          {.value = 2, .name = "liver"},
                          {.value = 2, .name = "tumour", .layer = 1},
                          {.value = 2, .name = "again"}}};
  const LabelTable first = labelsOfLayer(table, 0), second = labelsOfLayer(table, 1);
  ASSERT_EQ(first.labels.size(), 2u);
  EXPECT_EQ(first.reason, table.reason);
  EXPECT_EQ(first.labels[0].name, "liver");
  EXPECT_EQ(first.labels[1].name, "spleen");
  ASSERT_EQ(second.labels.size(), 1u);
  EXPECT_EQ(second.labels[0].name, "tumour");
  EXPECT_EQ(labelName(&first, 5), "spleen");
  EXPECT_EQ(labelName(&first, 7), "");
  EXPECT_EQ(labelName(nullptr, 5), "");
}

TEST(LabelTables, ColoursAreTheTablesElseDifferFromThoseOfNeighbours) {
  const LabelTable table{"stated", "", {{.value = 3, .color = glm::vec3(0.25f, 0.5f, 1.0f)}}};
  EXPECT_EQ(labelColor(&table, 3), glm::vec3(0.25f, 0.5f, 1.0f));
  EXPECT_EQ(labelColor(&table, 4), labelColor(nullptr, 4));
  for (int label = 1; label < 4096; ++label)
    for (const int other : {label + 1, label + 2})
      EXPECT_GT(glm::length(labelColor(nullptr, label) - labelColor(nullptr, other)), 0.2f) << label;
  for (const std::int64_t label : {std::int64_t{-7}, std::int64_t{1} << 40})
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(labelColor(nullptr, label)[i], 0.0f);
      EXPECT_LE(labelColor(nullptr, label)[i], 1.0f);
    }
}

TEST(LabelTables, SrgbBecomesLinear) {
  const glm::vec3 linear = linearFromSrgb({0.5, 2.0, std::nan("")});
  EXPECT_NEAR(linear.x, 0.21404, 1e-5);  // IEC 61966-2-1
  EXPECT_EQ(linear.y, 1.0f);
  EXPECT_EQ(linear.z, 0.0f);
}

}  // namespace
}  // namespace isolux::volume
