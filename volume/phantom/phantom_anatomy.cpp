#include "volume/phantom/phantom_anatomy.h"

#include <iterator>

namespace isolux::volume {

namespace {

using Vec = glm::vec3;

// What the eye sockets are: a cone that runs back and towards the middle.
void orbitCone(Solid& solid, float wider, bool remove, float blend) {
  const Vec apex(17, -44, 14), radiiApex = Vec(5.5f) + wider;
  if (remove) {  // two overlapping cones: the entrance is wide and rather square, and droops sideways
    solid.removeLimbs({28.5f, -92, 15.5f}, apex, Vec(15, 19, 15) + wider, radiiApex, blend);
    solid.removeLimbs({37.5f, -90, 12.5f}, apex, Vec(14, 19, 15) + wider, radiiApex, blend + 1.5f);
  } else {
    solid.addLimbs({31, -74, 14}, apex, Vec(19, 19, 16.5f) + wider, radiiApex, blend);
  }
}

void cranialCavity(Solid& solid, bool remove) {
  const auto put = [&](const Vec& centre, const Vec& radii, float blend) {
    remove ? solid.remove(centre, radii, blend) : solid.add(centre, radii, blend);
  };
  const auto putPair = [&](const Vec& centre, const Vec& radii, float blend) {
    remove ? solid.removePair(centre, radii, blend) : solid.addPair(centre, radii, blend);
  };
  put({0, 12, 50}, {63, 75, 56}, 1);
  put({0, -36, 58}, {45, 46, 32}, remove ? 1.0f : 12.0f);
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
  s.removePair({88, -52, 22}, {36, 34, 40}, 16);  // temporal fossa
  cranialCavity(s, true);
  // Base: body of the sphenoid and clivus, petrous pyramids, condyles, mastoids, styloids, pterygoids.
  s.addLimb({0, -28, -2}, {0, 12, -24}, {15, 14, 10}, {12, 8, 6}, 6);
  s.addLimbs({56, 12, -8}, {16, -4, -10}, {10, 10, 9}, {6, 6, 6}, 6);
  s.addPair({14, 19, -30}, {6, 9, 5}, 5);
  s.addLimbs({58, 17, -8}, {55, 13, -29}, {10, 12, 10}, {6, 7, 6}, 8);
  s.addLimbs({49, 8, -22}, {44, -4, -46}, {2.5, 2.5, 2.5}, {1.2, 1.2, 1.2}, 3);
  s.addLimbs({13, -44, -8}, {14, -42, -34}, {2.5, 7, 4}, {2, 5, 3}, 4);
  s.removeLimb({0, 26, -18}, {0, 24, -50}, {15, 17, 10}, {15, 17, 10}, 3);
  s.add({0, 91, 10}, {10, 5, 7}, 12);
  // Greater wing of the sphenoid behind the lateral wall of the orbit.
  s.addPair({42, -46, 10}, {9, 22, 22}, 8);
  // Orbits: a shell of bone, the rim, brow and glabella.
  orbitCone(s, 2.5f, false, 5);
  s.addLimbs({13, -87, 25}, {30, -86.5f, 32}, {5, 5, 5}, {6, 6, 5}, 10);
  s.addLimbs({30, -86.5f, 32}, {46, -79, 28}, {6, 6, 5}, {5.5, 5.5, 5}, 10);
  s.addLimbs({48, -77, 26}, {53, -70, 12}, {5, 5.5, 5}, {4.5, 6, 5}, 8);
  s.addLimbs({53, -70, 12}, {47, -76, -3}, {4.5, 6, 5}, {5.5, 6, 5.5}, 6);
  s.addLimbs({47, -76, -3}, {30, -82, -7}, {5.5, 6, 5.5}, {5, 5, 5}, 8);
  s.addLimbs({30, -82, -7}, {16, -85, 2}, {5, 5, 5}, {4, 4.5, 4}, 5);
  s.addLimbs({16, -85, 2}, {12, -87, 18}, {4, 4.5, 4}, {4, 4.5, 4}, 5);
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

void makeEars(Solid& s) {
  // Plate, and the helix round it from the concha over the top to the lobe.
  s.addLimbs({76, 9, 5}, {82, 15, 9}, {4, 13, 25}, {3.5f, 13, 24}, 6);
  constexpr Vec helix[] = {{79, 2, 2},      {77.5f, -3, 10},   {79, -2.5f, 20}, {81.5f, 3, 28.5f},
                           {84.5f, 11, 33}, {87, 19, 32},      {88.5f, 25, 26}, {89, 27.5f, 18},
                           {88, 26, 9},     {85.5f, 21.5f, 0}, {82.5f, 15, -9}, {80, 9, -16}};
  for (std::size_t i = 0; i + 1 < std::size(helix); ++i)
    s.addLimbs(helix[i], helix[i + 1], Vec(2.8f), Vec(2.8f), 3);
  s.addLimbs({79, 8, -12}, {77, 5, -22}, {4, 7, 7}, {4, 6.5f, 6.5f}, 6);
  // Antihelix, concha, tragus.
  s.addLimbs({84, 10, 24}, {87, 18, 10}, {2.5f, 3, 3}, {2.8f, 3.2f, 3}, 4);
  s.addLimbs({87, 18, 10}, {82, 10, -12}, {2.8f, 3.2f, 3}, {2.5f, 3, 3}, 4);
  s.removeLimbs({87, 5, 0}, {88, 9, 8}, {9, 6, 9}, {7, 5, 6}, 3);
  s.addPair({75, -6, -2}, {5, 4, 7}, 6);
}

void makeFlesh(Solid& s) {
  // Head without face: the brain case under 6 mm of scalp.
  s.add({0, 6, 46}, {76, 94.5f, 71.5f}, 0);
  s.add({0, -38, 42}, {60, 57.5f, 56}, 12);
  s.add({0, 46, 28}, {67, 55.5f, 54}, 14);
  s.add({0, 38, 2}, {56, 50, 38}, 14);
  // Face, cheekbones, jaw, chin, cheeks.
  s.add({0, -44, -22}, {58, 46, 63}, 20);
  s.addPair({43, -61, -10}, {21, 25, 19}, 16);
  s.addPair({30, -70, -16}, {20, 21, 20}, 14);
  s.addPair({56, -38, 6}, {13, 34, 32}, 14);
  s.addPair({59, -16, -22}, {13, 20, 30}, 14);
  s.addLimbs({8, -80, -84}, {43, -38, -68}, {14, 15, 13}, {14, 16, 15}, 16);
  s.addLimbs({43, -38, -68}, {55, -14, -16}, {16, 17, 16}, {14, 18, 18}, 16);
  s.addPair({33, -58, -42}, {23, 27, 28}, 16);
  s.add({0, -75, -45}, {34, 28, 32}, 20);
  s.addPair({22, -72, -76}, {15, 14, 17}, 16);
  s.addPair({42, -44, -52}, {17, 25, 22}, 18);
  s.addPair({57, -36, -9}, {13.5f, 28, 17}, 14);
  s.add({0, -86, -87}, {16, 15, 12}, 14);
  // Neck, with the larynx and the muscles that run from behind the ears to the breastbone.
  s.addLimb({0, 30, -30}, {0, 34, -150}, {50, 48, 40}, {54, 46, 40}, 14);
  s.addLimb({0, -20, -60}, {0, -2, -150}, {36, 26, 30}, {40, 26, 30}, 14);
  s.add({0, -34, -108}, {8, 7, 13}, 12);
  s.addLimbs({60, 20, -20}, {20, -22, -140}, {9, 11, 9}, {9, 9, 9}, 10);
  // Brows and the hollows of the eyes.
  s.addLimbs({10, -92, 32}, {45, -80, 31}, {8, 7, 6}, {8, 8, 6}, 12);
  s.removeLimbs({23, -104, 14}, {41, -99, 13}, {7, 13, 7}, {8, 13, 7}, 12);
  // Nose: bridge, tip, wings, columella.
  s.addLimb({0, -91, 27}, {0, -112, -9}, {6, 8, 8}, {7.5f, 9, 8}, 10);
  s.add({0, -113, -13}, {9.5f, 9, 8}, 8);
  s.addPair({11, -103, -17}, {7, 10, 7}, 11);
  s.addLimbs({4, -95, 16}, {11, -101, -14}, {6, 8, 8}, {8, 10, 8}, 10);
  s.addLimb({0, -111, -18}, {0, -98, -25}, {3.5f, 5, 4}, {5, 5, 4}, 6);
  s.addPair({33, -73, 12}, {24, 15.5f, 21}, 8);
  // Closed lids with their slit.
  s.addPair({32, -77, 12.5f}, {16.5f, 14, 13}, 6);
  constexpr Vec slit[] = {
      {18.5f, -86.5f, 10.5f}, {25, -91, 7.4f}, {32, -92.5f, 6.2f}, {39, -90.5f, 7.2f}, {46, -85, 10}};
  for (std::size_t i = 0; i + 1 < std::size(slit); ++i)
    s.removeLimbs(slit[i], slit[i + 1], {1, 3.5f, 0.9f}, {1, 3.5f, 0.9f}, 2);
  // Lips.
  s.addLimb({-4, -102, -43}, {4, -102, -43}, {7, 4.5f, 4}, {7, 4.5f, 4}, 5);
  s.addLimbs({4, -102, -43}, {23, -91, -47}, {6, 4.5f, 4}, {3, 3.5f, 2}, 5);
  s.addLimb({-6, -101, -52}, {6, -101, -52}, {7, 5, 4.5f}, {7, 5, 4.5f}, 5);
  s.addLimbs({6, -101, -52}, {22, -91, -48.5f}, {6, 4.5f, 4}, {3, 3.5f, 2}, 5);
  s.removeLimb({-10, -109, -47.3f}, {10, -109, -47.3f}, {6, 8, 0.8f}, {6, 8, 0.8f}, 3);
  s.removeLimbs({10, -108, -47.3f}, {26, -97, -48.5f}, {4, 7, 0.8f}, {3, 5, 0.7f}, 3);
  makeEars(s);
}

void makeAirways(Solid& s) {
  s.addLimb({0, -74, 2}, {0, -70, -16}, {4, 16, 6}, {10.5f, 22, 7}, 0);
  s.addLimbs({6, -108, -27}, {7, -90, -15}, {3, 3.5f, 4}, {4, 5, 5}, 4);
  s.addLimb({0, -50, -14}, {0, -32, -30}, {11, 8, 10}, {12, 7, 8}, 6);
  s.addLimb({0, -32, -30}, {0, -24, -78}, {12, 7, 8}, {11, 6, 8}, 6);
  s.addLimb({0, -24, -78}, {0, -14, -160}, {11, 6, 8}, {9, 9, 9}, 6);
  s.addLimbs({90, 4, -2}, {38, 1, -3}, {3.5f, 3.5f, 3.5f}, {2.5f, 2.5f, 2.5f}, 2);
  s.remove({0, -84, -8}, {1.3f, 40, 24}, 1);
  s.removeLimbs({9, -80, -16}, {9, -56, -16}, {3, 4, 5}, {3, 4, 5}, 2);
}

}  // namespace

Anatomy makeAnatomy() {
  Anatomy anatomy;
  makeFlesh(anatomy[Organ::flesh]);
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
