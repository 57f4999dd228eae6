#include "volume/phantom_anatomy.h"

namespace isolux::volume {

namespace {

using Vec = glm::vec3;

// What the eye sockets are: a cone that runs back and towards the middle.
void orbitCone(Solid& solid, float wider, bool remove, float blend) {
  const Vec front(33, -90, 14), apex(17, -44, 14);
  const Vec radiiFront = Vec(19.0f, 19.0f, 16.5f) + wider, radiiApex = Vec(5.5f) + wider;
  if (remove)
    solid.removeLimbs(front, apex, radiiFront, radiiApex, blend);
  else
    solid.addLimbs(Vec(32.2f, -80, 14), apex, radiiFront, radiiApex, blend);
}

void cranialCavity(Solid& solid, bool remove) {
  const auto put = [&](Vec centre, Vec radii, float blend) {
    remove ? solid.remove(centre, radii, blend) : solid.add(centre, radii, blend);
  };
  const auto putPair = [&](Vec centre, Vec radii, float blend) {
    remove ? solid.removePair(centre, radii, blend) : solid.addPair(centre, radii, blend);
  };
  put({0, 12, 50}, {63, 75, 56}, 1);
  put({0, -36, 58}, {49, 46, 32}, remove ? 1.0f : 12.0f);
  putPair({34, -6, 13}, {27, 32, 22}, remove ? 1.0f : 8.0f);
  put({0, 40, 4}, {45, 40, 27}, remove ? 1.0f : 8.0f);
}

void makeSkull(Solid& s) {
  // Brain case.
  s.add({0, 6, 47}, {70, 88, 65}, 0);
  s.add({0, -38, 42}, {56, 52, 50}, 12);
  s.add({0, 46, 28}, {62, 50, 48}, 14);
  s.add({0, 38, 2}, {50, 44, 32}, 14);
  s.addPair({38, -4, 12}, {29, 40, 28}, 10);
  cranialCavity(s, true);
  // Base: body of the sphenoid and clivus, petrous pyramids, condyles, mastoids, styloids, pterygoids.
  s.addLimb({0, -28, -2}, {0, 12, -24}, {15, 14, 10}, {12, 8, 6}, 6);
  s.addLimbs({56, 12, -8}, {16, -4, -10}, {10, 10, 9}, {6, 6, 6}, 6);
  s.addPair({14, 19, -30}, {6, 9, 5}, 5);
  s.addLimbs({58, 17, -8}, {55, 13, -29}, {10, 12, 10}, {6, 7, 6}, 8);
  s.addLimbs({49, 8, -22}, {44, -4, -46}, {2.5, 2.5, 2.5}, {1.2, 1.2, 1.2}, 3);
  s.addLimbs({13, -44, -8}, {14, -42, -34}, {2.5, 7, 4}, {2, 5, 3}, 4);
  s.removeLimb({0, 26, -18}, {0, 24, -50}, {15, 17, 10}, {15, 17, 10}, 3);
  s.add({0, 95, 10}, {9, 5, 6}, 10);
  // Greater wing of the sphenoid behind the lateral wall of the orbit.
  s.addPair({42, -46, 10}, {9, 22, 22}, 8);
  // Orbits: a shell of bone, the rim, brow and glabella.
  orbitCone(s, 3.0f, false, 5);
  s.addLimbs({13, -89, 24}, {30, -89, 33}, {5, 5, 5}, {6, 6, 5.5}, 6);
  s.addLimbs({30, -89, 33}, {47, -80, 28}, {6, 6, 5.5}, {5.5, 5.5, 5.5}, 6);
  s.addLimbs({48, -79, 27}, {53, -71, 12}, {5, 5.5, 5}, {4.5, 6, 5}, 6);
  s.addLimbs({53, -71, 12}, {47, -77, -3}, {4.5, 6, 5}, {5.5, 6, 5.5}, 6);
  s.addLimbs({47, -77, -3}, {30, -85, -7}, {5.5, 6, 5.5}, {5, 5, 5}, 6);
  s.addLimbs({30, -85, -7}, {16, -87, 2}, {5, 5, 5}, {4, 4.5, 4}, 5);
  s.addLimbs({16, -87, 2}, {12, -88, 18}, {4, 4.5, 4}, {4, 4.5, 4}, 5);
  s.add({0, -87, 32}, {17, 8, 9}, 10);
  // Nasal bones and the frontal processes of the maxilla.
  s.addLimb({0, -91, 27}, {0, -105, 5}, {4, 5, 5}, {4.5, 4, 4}, 6);
  s.addLimbs({4, -91, 24}, {7, -100, 3}, {4, 5, 5}, {4, 4, 4}, 5);
  s.addLimbs({10, -90, 14}, {15, -90, -10}, {4, 5, 5}, {4.5, 5, 5}, 5);
  // Maxilla: body, margin of the nasal aperture, alveolar process, palate, nasal spine.
  s.addPair({25, -70, -17}, {19, 18, 20}, 8);
  s.addLimbs({15, -90, -8}, {16, -89, -27}, {4.5, 5, 5}, {7, 6, 6}, 6);
  s.addLimb({-10, -91, -32}, {10, -91, -32}, {7, 5.5, 7}, {7, 5.5, 7}, 5);
  s.addLimbs({9, -91, -36}, {20, -84, -37}, {6, 5.5, 8}, {6, 6, 8}, 5);
  s.addLimbs({20, -84, -37}, {28, -66, -37}, {6, 6, 8}, {6, 7, 8}, 5);
  s.addLimbs({28, -66, -37}, {29, -50, -34}, {6, 7, 8}, {6, 6, 8}, 5);
  s.add({0, -68, -31}, {24, 26, 3.5}, 4);
  // Zygomatic bones and arches.
  s.addLimbs({48, -75, -5}, {53, -67, -13}, {7, 7, 8}, {7, 8, 8}, 6);
  s.addLimbs({51, -69, -14}, {34, -72, -25}, {8, 8, 8}, {8, 9, 8}, 8);
  s.addLimbs({57, -62, -12}, {66, -40, -9}, {3.5, 6, 5.5}, {2.8, 5, 4.5}, 6);
  s.addLimbs({66, -40, -9}, {67, -16, -4}, {2.8, 5, 4.5}, {3, 5, 4}, 5);
  s.addLimbs({67, -16, -4}, {62, 2, -1}, {3, 5, 4}, {5, 6, 5}, 6);
  // Openings: nose, orbits with their fissures, infraorbital foramina, ear canals.
  s.removeLimb({0, -96, 3}, {0, -94, -17}, {4.5, 34, 6}, {12, 36, 8.5}, 3);
  s.addLimb({0, -91, -27}, {0, -98, -25}, {3, 3, 3}, {1.3, 1.5, 1.3}, 4);
  orbitCone(s, 0.0f, true, 2.5f);
  s.removeLimbs({22, -48, 6}, {42, -66, -1}, {3, 3, 3}, {2.5, 2.5, 2.5}, 2);
  s.removeLimbs({20, -46, 18}, {30, -54, 24}, {2.5, 3, 2.5}, {1.5, 3, 1.5}, 2);
  s.removeLimbs({26, -92, -14}, {27, -78, -8}, {2, 2, 2}, {1.5, 1.5, 1.5}, 1.5f);
  s.removeLimbs({76, 3, -2}, {36, 1, -3}, {4.5, 4.5, 4.5}, {3, 3, 3}, 2);
  // Inside the nose: septum and lower turbinates.
  s.add({0, -68, -8}, {1.3f, 21, 20}, 1);
  s.addLimbs({9, -78, -16}, {9, -56, -16}, {1.8f, 3, 4}, {1.8f, 3, 4}, 1);
}

void makeMandible(Solid& s) {
  s.addLimb({-9, -86, -78}, {9, -86, -78}, {7, 6, 13}, {7, 6, 13}, 0);
  s.add({0, -90, -86}, {13, 6, 6}, 6);
  s.addLimbs({9, -86, -78}, {24, -77, -75}, {7, 6, 13}, {6, 6, 13}, 6);
  s.addLimbs({24, -77, -75}, {38, -54, -69}, {6, 6, 13}, {5.5, 7, 12.5}, 6);
  s.addLimbs({38, -54, -69}, {47, -30, -60}, {5.5, 7, 12.5}, {5, 8, 13}, 6);
  s.addLimbs({47, -27, -58}, {52, -17, -22}, {4, 12, 12}, {3.5, 12, 9}, 6);
  s.addLimbs({51, -29, -28}, {50, -35, -3}, {3, 7, 7}, {2, 3, 3}, 5);
  s.addLimbs({53, -10, -22}, {54, -7, -8}, {4, 6, 6}, {5, 4.5, 5}, 5);
  s.addPair({54, -7, -6}, {9, 4.5, 4.5}, 4);
  s.removeLimbs({24, -90, -76}, {23, -78, -74}, {1.8f, 1.8f, 1.8f}, {1.5f, 1.5f, 1.5f}, 1.5f);
}

void makeTeeth(Solid& s) {
  struct Tooth {
    float x, y, halfWidthX, halfWidthY;
  };
  // From the middle backwards: incisors, canine, premolars, molars.
  constexpr Tooth upper[] = {{4.3f, -95.0f, 4.2f, 2.6f},  {12.2f, -92.4f, 3.4f, 2.6f},
                             {19.0f, -87.3f, 3.4f, 3.4f}, {24.0f, -80.6f, 3.8f, 3.3f},
                             {27.0f, -73.6f, 4.2f, 3.3f}, {29.2f, -64.6f, 4.8f, 4.9f},
                             {30.4f, -54.4f, 4.8f, 4.7f}};
  constexpr Tooth lower[] = {{2.8f, -91.6f, 2.7f, 2.4f},  {8.5f, -90.4f, 2.9f, 2.5f},
                             {14.8f, -86.6f, 3.2f, 3.0f}, {20.0f, -80.8f, 3.5f, 3.3f},
                             {23.7f, -74.2f, 3.7f, 3.3f}, {26.8f, -65.2f, 4.5f, 5.1f},
                             {28.9f, -54.6f, 4.5f, 5.0f}};
  for (const Tooth& t : upper) {
    s.addLimbs({t.x, t.y, -50.5f}, {t.x, t.y, -47}, {t.halfWidthX, t.halfWidthY, 3},
               {t.halfWidthX * 0.95f, t.halfWidthY * 1.05f, 3}, 0);
    s.addLimbs({t.x, t.y, -46}, {t.x * 0.97f, t.y + 2.0f, -30}, {t.halfWidthX * 0.7f, t.halfWidthY * 0.8f, 3},
               {1.6f, 1.6f, 3}, 3);
  }
  for (const Tooth& t : lower) {
    s.addLimbs({t.x, t.y, -57}, {t.x, t.y, -60}, {t.halfWidthX, t.halfWidthY, 2.6f},
               {t.halfWidthX * 0.95f, t.halfWidthY, 2.6f}, 0);
    s.addLimbs({t.x, t.y, -61}, {t.x * 1.03f, t.y + 2.0f, -76}, {t.halfWidthX * 0.7f, t.halfWidthY * 0.8f, 3},
               {1.6f, 1.6f, 3}, 3);
  }
}

void makeSpine(Solid& s) {
  // Atlas and axis.
  s.addPair({20, 20, -40}, {8, 10, 6}, 0);
  s.addLimb({-9, 8, -40}, {9, 8, -40}, {5, 4, 5}, {5, 4, 5}, 5);
  s.addLimbs({9, 8, -40}, {18, 15, -40}, {4, 4, 5}, {5, 5, 6}, 5);
  s.addLimbs({20, 26, -40}, {10, 44, -42}, {4, 4, 4}, {3.5f, 3.5f, 4}, 5);
  s.addLimb({-8, 45, -42}, {8, 45, -42}, {4, 3.5f, 4}, {4, 3.5f, 4}, 4);
  s.addLimbs({24, 21, -40}, {38, 22, -41}, {5, 5, 4}, {4, 4, 3.5f}, 4);
  s.addLimb({0, 16, -34}, {0, 15, -54}, {5, 5, 5}, {8, 7, 6}, 2);
  // Third to seventh vertebrae and the lower part of the second, along the neck's curve.
  for (int i = 0; i < 5; ++i) {
    const float z = -56.0f - 15.5f * static_cast<float>(i);
    const float bow = static_cast<float>(i) - 1.5f;
    const float y = 12.0f + 0.7f * bow * bow;
    s.addLimb({-5, y, z}, {5, y, z}, {8, 8.5f, 6}, {8, 8.5f, 6}, 1.5f);
    s.addPair({17, y + 13, z}, {6.5f, 7, 6.5f}, 3);
    s.addLimbs({10, y + 4, z}, {16, y + 11, z}, {3.5f, 3.5f, 4}, {4, 4, 5}, 3);
    s.addLimbs({10, y + 1, z}, {24, y + 5, z - 1}, {4, 4, 3}, {4, 4.5f, 3.5f}, 3);
    s.addLimbs({15, y + 19, z}, {2, y + 31, z - 3}, {4, 4, 5}, {3, 3.5f, 4.5f}, 3);
    s.addLimb({0, y + 31, z - 3}, {0, y + 44, z - 8}, {3, 4, 4.5f}, {4, 4, 3.5f}, 3);
  }
  // Hyoid bone.
  s.addLimb({-8, -36, -92}, {8, -36, -92}, {4, 3, 4}, {4, 3, 4}, 2);
  s.addLimbs({8, -36, -92}, {20, -22, -89}, {3, 3, 3}, {2, 2, 2}, 2);
}

void makeBody(Solid& s) {
  // Head without face.
  s.add({0, 5, 45}, {76, 96, 73}, 0);
  s.add({0, -40, 42}, {62, 57, 58}, 14);
  s.add({0, 46, 24}, {68, 56, 56}, 16);
  // Face and jaw.
  s.add({0, -46, -22}, {58, 46, 62}, 18);
  s.addPair({44, -62, -14}, {22, 25, 20}, 14);
  s.addLimbs({10, -80, -84}, {46, -34, -66}, {14, 13, 14}, {15, 16, 16}, 14);
  s.addLimbs({46, -34, -66}, {57, -10, -10}, {15, 16, 16}, {16, 20, 18}, 14);
  s.add({0, -84, -86}, {18, 14, 13}, 14);
  s.add({0, -76, -46}, {33, 26, 26}, 12);
  // Neck.
  s.addLimb({0, 22, -30}, {0, 26, -150}, {54, 56, 40}, {56, 54, 40}, 18);
  s.add({0, -30, -112}, {9, 8, 16}, 14);
  s.addLimbs({56, 16, -22}, {22, -14, -140}, {9, 11, 9}, {9, 9, 9}, 12);
  // Brows and eye hollows.
  s.addLimbs({8, -93, 32}, {46, -82, 31}, {8, 8, 6.5f}, {8, 9, 7}, 10);
  s.removeLimbs({24, -103, 14}, {42, -98, 14}, {9, 14, 9.5f}, {9, 14, 9}, 10);
  // Nose: bridge, tip, wings.
  s.addLimb({0, -91, 28}, {0, -115, -12}, {7, 9, 8}, {8, 9, 8}, 9);
  s.add({0, -117, -15}, {9.5f, 9, 8.5f}, 6);
  s.addPair({11.5f, -106, -18}, {6.5f, 9.5f, 7.5f}, 5);
  // Closed lids over the eyes.
  s.addPair({32, -77, 13}, {14.5f, 14, 13.5f}, 5);
  s.removeLimbs({21, -90, 9.5f}, {32, -93, 7}, {1.5f, 4, 1.0f}, {1.5f, 4, 1.2f}, 2);
  s.removeLimbs({32, -93, 7}, {44, -87, 9.5f}, {1.5f, 4, 1.2f}, {1.5f, 4, 1.0f}, 2);
  // Lips.
  s.addLimb({-6, -101, -42.5f}, {6, -101, -42.5f}, {8, 5.5f, 4.5f}, {8, 5.5f, 4.5f}, 5);
  s.addLimbs({6, -101, -42.5f}, {22, -92, -46}, {7, 5.5f, 4.5f}, {4, 4, 2.5f}, 5);
  s.addLimb({-7, -100, -52}, {7, -100, -52}, {8, 5.5f, 5}, {8, 5.5f, 5}, 5);
  s.addLimbs({7, -100, -52}, {21, -92, -48}, {6, 5, 4.5f}, {4, 4, 2.5f}, 5);
  s.removeLimb({-10, -107, -47}, {10, -107, -47}, {6, 8, 1.0f}, {6, 8, 1.0f}, 3);
  s.removeLimbs({10, -106, -47}, {25, -97, -48}, {4, 7, 1.0f}, {3, 5, 0.8f}, 3);
  // Ears.
  s.addLimbs({70, 2, 6}, {82, 17, 10}, {4, 12, 22}, {3.5f, 15, 26}, 5);
  s.addLimbs({74, 3, -18}, {78, 5, -22}, {4, 7, 8}, {3.5f, 7, 8}, 4);
  s.removeLimbs({83, 3, 3}, {86, 12, 10}, {6, 7, 10}, {7, 9.5f, 17}, 4);
  s.addLimbs({72, -6, 0}, {77, -4, 0}, {4, 3.5f, 6}, {3, 3, 5}, 3);
}

void makeAirways(Solid& s) {
  s.addLimb({0, -92, 2}, {0, -88, -16}, {4, 24, 6}, {10.5f, 28, 7}, 0);
  s.addLimbs({6, -115, -26}, {7, -96, -14}, {3.2f, 4, 4}, {4, 5, 5}, 4);
  s.addLimb({0, -50, -14}, {0, -32, -30}, {11, 8, 10}, {12, 7, 8}, 6);
  s.addLimb({0, -32, -30}, {0, -24, -78}, {12, 7, 8}, {11, 6, 8}, 6);
  s.addLimb({0, -24, -78}, {0, -18, -160}, {11, 6, 8}, {9, 9, 9}, 6);
  s.addLimbs({92, 2, -2}, {38, 1, -3}, {3.5f, 3.5f, 3.5f}, {2.5f, 2.5f, 2.5f}, 2);
  s.remove({0, -84, -8}, {1.3f, 40, 24}, 1);
  s.removeLimbs({9, -80, -16}, {9, -56, -16}, {3, 4, 5}, {3, 4, 5}, 2);
}

}  // namespace

Anatomy makeAnatomy() {
  Anatomy anatomy;
  makeBody(anatomy[Organ::body]);
  cranialCavity(anatomy[Organ::brain], false);
  anatomy[Organ::ventricles]
      .addLimbs({9, -26, 50}, {14, 26, 52}, {5, 9, 6}, {6, 10, 7}, 0)
      .add({0, 2, 40}, {2.5f, 14, 9}, 3);
  anatomy[Organ::orbits].addLimbs({33, -90, 14}, {17, -44, 14}, {19.5f, 19.5f, 17}, {6, 6, 6}, 0);
  anatomy[Organ::eyes].addPair({32, -76, 13}, {12, 12, 12}, 0);
  anatomy[Organ::lenses].addPair({32, -84.5f, 13}, {4.5f, 2, 4.5f}, 0);
  makeAirways(anatomy[Organ::airways]);
  makeSkull(anatomy[Organ::skull]);
  makeMandible(anatomy[Organ::mandible]);
  makeSpine(anatomy[Organ::spine]);
  makeTeeth(anatomy[Organ::teeth]);
  anatomy[Organ::sinuses]
      .addPair({25, -69, -15}, {12, 12, 13}, 0)
      .addPair({9, -84, 34}, {7, 3, 7}, 2)
      .add({0, -24, -2}, {10, 9, 6}, 0);
  anatomy[Organ::marker].add({79, 4, -27}, {3.5f, 3.5f, 3.5f}, 0);
  return anatomy;
}

}  // namespace isolux::volume
