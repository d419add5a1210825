#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "simworld/collision/mesh.hpp"

namespace skein {

MeshResult read_mesh(const std::string& file, const Vec3& at_m, double scale) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                                     aiProcess_PreTransformVertices | aiProcess_SortByPType);
  if (scene == nullptr) return std::string("cannot be read: ") + importer.GetErrorString();
  std::vector<Vec3> points_m;
  std::vector<Mesh::Triangle> triangles;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& part = *scene->mMeshes[m];
    const auto first = static_cast<std::uint32_t>(points_m.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D& p = part.mVertices[i];
      points_m.emplace_back(at_m + scale * Vec3(p.x, p.y, p.z));
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices != 3) continue;  // points and lines have no surface
      triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
  }
  try {
    return Mesh(std::move(points_m), std::move(triangles));
  } catch (const std::invalid_argument& fault) {
    return std::string(fault.what());
  }
}

}  // namespace skein
