// The texts of `interlock template`: cases as they were when the program was built, so that a
// template is a case that is run and tested. The build makes one function for each pair of
// experiment and case that apps/CMakeLists.txt lists.
#pragma once

namespace interlock::apps
{
const char* pull_out_template();   // cases/pullout/pullout.prm
const char* heap_template();       // cases/heap/heap.prm
const char* laboratory_template(); // cases/geogrids/bx1100.prm
const char* packing_template();    // cases/benchmark/w1.prm
const char* shear_box_template();  // cases/ballast/shear_box.prm
const char* triaxial_template();   // cases/ballast/triaxial.prm
const char* study_template();      // cases/studies/quick_flexibility.prm
} // namespace interlock::apps
