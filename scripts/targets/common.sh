# What the targets that run beside SimSpark share.
cppflags="-DSPDLOG_COMPILED_LIB -DSPDLOG_SHARED_LIB -DSPDLOG_FMT_EXTERNAL"
libraries="-lode -lBulletDynamics-float64 -lBulletCollision-float64 -lLinearMath-float64 -lz -lyaml-cpp -ltinyxml2 -lspdlog -lfmt -lwebsockets -lncursesw -ltinfo -lpthread"
# The same bytes on every machine: no -march=native, no -ffast-math, no fused multiply-add.
strictFloat="-ffp-contract=off -fno-math-errno -fno-trapping-math"
systemIncludeDirs="/usr/include/eigen3 /usr/include/bullet"
ignoredDirs="src/modules/nao tests/modules/nao"
# MuJoCo, where it is installed, is in benchmarks only: --as-needed keeps it out of those that do not use it.
benchLibraries="-lbenchmark_main -lbenchmark -lgtest"
if [[ -f /usr/include/mujoco/mujoco.h ]]; then benchLibraries+=" -lmujoco"; fi
