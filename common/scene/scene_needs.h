#pragma once

namespace caustic {

/// What a scene needs of an integrator; the rest is skipped.
struct SceneNeeds {
    bool specular = false;     ///< mirrors or smooth boundaries: delta lobes to follow
    bool diffuse = false;      ///< diffuse surfaces: receivers of photons
    bool glossy = false;       ///< lobes around a direction
    bool areaLights = false;   ///< lights with an extent: more than one shadow sample makes sense
    bool environment = false;  ///< light from beyond the scene
    bool ambient = false;      ///< light from everywhere that nothing shades
    bool lens = false;         ///< a lens with an extent
    bool interiors = false;    ///< objects that something fills: a path has to know where it is
    bool medium = false;       ///< a medium that absorbs or scatters
    bool scattering = false;   ///< a medium that scatters: paths have vertices in it
    bool textures = false;     ///< colours that vary over a surface
};

}  // namespace caustic
