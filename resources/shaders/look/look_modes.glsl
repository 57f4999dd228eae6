// Numbers of scene::LookMode, scene::Shading and scene::SolidTexture; a test compares them with the settings' names.
#define LOOK_BLINN_PHONG 0
#define LOOK_LAMBERT 1
#define LOOK_TONE 2
#define LOOK_KAPPA1 3
#define LOOK_KAPPA2 4
#define LOOK_MEAN_CURVATURE 5
#define LOOK_GAUSSIAN_CURVATURE 6
#define LOOK_SHAPE_INDEX 7
#define LOOK_CURVEDNESS 8
#define LOOK_CURVATURE_2D 9
#define LOOK_ACCESSIBILITY 10
#define LOOK_FLOW 11
#define LOOK_GI 12
#define LOOK_NORMAL 13
#define LOOK_DEPTH 14

#define SHADING_UNLIT 0
#define SHADING_LAMBERT 1
#define SHADING_BLINN_PHONG 2
#define SHADING_TONE 3
#define SHADING_GI 4

#define TEXTURE_NONE 0
#define TEXTURE_MARBLE 1
#define TEXTURE_WOOD 2
#define TEXTURE_CHECKER 3
