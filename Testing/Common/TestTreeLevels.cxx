// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TreeLevels.h"

#include <gtest/gtest.h>

using namespace littoral;

TEST(TreeLevels, LowHasFourPolygonsInTheBounds)
{
  for (const TreePreset preset : { TreePreset::Pine, TreePreset::Oak, TreePreset::Birch, TreePreset::Shrub })
  {
    const ReevesTreeParameters parameters = PresetParameters(preset);
    const PlantMesh mesh = LowTree(parameters);
    ASSERT_EQ(mesh.NumberOfPolygons(), 4);
    EXPECT_EQ(mesh.Colours.size(), mesh.Points.size());
    for (int polygon = 0; polygon < 4; ++polygon)
    {
      const int first = mesh.Offsets[polygon];
      ASSERT_GE(mesh.Offsets[polygon + 1] - first, 3);
      Vector3 area{ 0.0, 0.0, 0.0 };
      for (int i = first + 1; i + 1 < mesh.Offsets[polygon + 1]; ++i)
      {
        const Vector3& a = mesh.Points[mesh.Corners[first]];
        area = area + glm::cross(mesh.Points[mesh.Corners[i]] - a, mesh.Points[mesh.Corners[i + 1]] - a);
      }
      EXPECT_GT(glm::dot(area, mesh.Normals[mesh.Corners[first]]), 0.01);
    }
    for (const Vector3& point : mesh.Points)
    {
      EXPECT_LE(std::hypot(point[0], point[1]), parameters.CrownRadius * (1.0 + 1e-12));
      EXPECT_GE(point[2], 0.0);
      EXPECT_LE(point[2], parameters.Height * (1.0 + 1e-12));
    }
  }
}
