#!/usr/bin/env bash
# Outputs named .a and .so, and targets that depend on a library target.
source "$(dirname "$0")/project.bash"
mkdir -p lib/words app
printf '#pragma once\nint word();\n' > lib/words/Word.h
printf '#include "words/Word.h"\nint word() { return 5; }\n' > lib/words/Word.cpp
printf '#include <cstdio>\n#include "words/Word.h"\nint main() { std::printf("%%d\\n", word()); }\n' > app/main.cpp

for kind in a so; do
  ./configure.sh --target Words --output libwords.$kind --source-dirs lib --include-dirs lib > /dev/null
  ./configure.sh --target App --output app --source-dirs app --include-dirs lib --depends Words > /dev/null
  expect "the last one configured is the default" "$(cat build/default)" App
  builds
  expect ".$kind compiles library and program" "$(compiled)" "app/main.cpp lib/words/Word.cpp"
  exists build/Words/lib/libwords.$kind
  expect ".$kind works" "$(build/App/bin/app)" 5
  expect ".$kind works elsewhere" "$(cd / && "$project/build/App/bin/app")" 5

  # A change in the library is seen from the program's target.
  sed -i 's/5/6/' lib/words/Word.cpp
  builds App
  expect ".$kind change compiles" "$(compiled)" "lib/words/Word.cpp"
  expect ".$kind change takes effect" "$(build/App/bin/app)" 6
  # So is a new file.
  printf 'int other() { return 1; }\n' > lib/words/Other.cpp
  builds App
  expect ".$kind added file" "$(compiled)" "lib/words/Other.cpp"
  builds App
  expect ".$kind nothing changed" "$log" "make: Nothing to be done for 'App'."
  rm lib/words/Other.cpp
  sed -i 's/6/5/' lib/words/Word.cpp
  builds clean
done

# The project's own library may be shared, too.
writeSources
./configure.sh --target SimRelease --library libplumbline.so --library-dir lib > /dev/null
builds SimRelease-tests
exists lib/libplumbline.so
expect "shared library" "$(bin/tool)" "two 2"
expect "shared library, modules" "$(cd / && "$project/bin/agent")" "1 modules"
builds clean
missing lib/libplumbline.so
exists lib/words/Word.cpp
finish
