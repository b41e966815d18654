// Reads a VRML file with Coin and prints its number of triangles and its volume.
//
// usage: coin FILE

#include <Inventor/SbVec3f.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLGroup.h>
#include <Inventor/actions/SoCallbackAction.h>

#include <array>
#include <cstdio>

namespace {

struct Sums {
    long triangles = 0;
    double volume = 0;
};

using Vector = std::array<double, 3>;

Vector position(const SoPrimitiveVertex* vertex) {
    const SbVec3f& point = vertex->getPoint();
    return {point[0], point[1], point[2]};
}

double determinant(const Vector& a, const Vector& b, const Vector& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

void add(void* data, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
         const SoPrimitiveVertex* c) {
    Sums& sums = *static_cast<Sums*>(data);
    sums.triangles += 1;
    sums.volume += determinant(position(a), position(b), position(c)) / 6;
}

}  // namespace

int main(int count, char** words) {
    SoDB::init();
    SoInput input;
    if (count != 2 || !input.openFile(words[1])) return 2;
    SoVRMLGroup* root = SoDB::readAllVRML(&input);
    if (root == nullptr) return 1;
    root->ref();
    Sums sums;
    SoCallbackAction action;
    action.addTriangleCallback(SoNode::getClassTypeId(), add, &sums);
    action.apply(root);
    std::printf("%ld %.17g\n", sums.triangles, sums.volume);
    return 0;
}
