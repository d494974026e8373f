# What the targets that run beside SimSpark share.
cppflags="-DSPDLOG_COMPILED_LIB -DSPDLOG_SHARED_LIB -DSPDLOG_FMT_EXTERNAL"
libraries="-lode -lz -lyaml-cpp -ltinyxml2 -lspdlog -lfmt -lwebsockets -lncursesw -ltinfo -lpthread"
# The same bytes on every machine: no -march=native, no -ffast-math, no fused multiply-add.
strictFloat="-ffp-contract=off -fno-math-errno -fno-trapping-math"
ignoredDirs="src/modules/nao tests/modules/nao"
