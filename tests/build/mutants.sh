#!/usr/bin/env bash
# What scripts/mutation.sh changes: numbers of constants and of comparisons in walk and diagnosis, operators elsewhere;
# nothing in comments, texts and types.
source "$(dirname "$0")/../e2e/assert.bash"
root=$PWD
cd "$scratch" || exit 1
mkdir -p src/{gap,robot}
cat > src/gap/Limits.cpp << 'END'
#include <array>
constexpr double share = 0.5, none = 0;  // not this 0.25
constexpr int tries = 10, one = 1;
constexpr std::array<double, 2> both = {
    2.0,
    4e-3};
constexpr double half(double x) { return 0.5 * x; }
bool far(double x) { return x > 1.5 && x < y[3] && "0.75 > 0.5"; } /* 3.5 < 4.5
 > 2.5 */
END
cat > src/robot/Arm.cpp << 'END'
bool near(std::vector<int> a) { return a.size() < 3 && !late; }  // a || b
int sum(int a) { return std::min(a + 1, a >> 2); }
bool untrue = false;
END
list() { awk -v thresholds='^src/(walking|gap)/' -f "$root/scripts/mutants.awk" src/gap/Limits.cpp src/robot/Arm.cpp; }
list > list.txt
expectEqual "$(cut -f1,2,3,5 list.txt | tr '\t' ' ')" "threshold src/gap/Limits.cpp 2 0.5
threshold src/gap/Limits.cpp 3 10
threshold src/gap/Limits.cpp 3 1
threshold src/gap/Limits.cpp 5 2.0
threshold src/gap/Limits.cpp 6 4e-3
threshold src/gap/Limits.cpp 8 1.5
operator src/robot/Arm.cpp 1  < 
operator src/robot/Arm.cpp 1  && 
operator src/robot/Arm.cpp 2  + 
operator src/robot/Arm.cpp 2 std::min(
operator src/robot/Arm.cpp 3 false" "what is changed"
# 30 % up or down, whole numbers by one at least, and the same each time.
while IFS=$'\t' read -r kind _ _ _ from to; do
  [[ $kind == threshold ]] || continue
  case $from in
    0.5) [[ $to == 0.65 || $to == 0.35 ]] ;;
    10) [[ $to == 13 || $to == 7 ]] ;;
    1) [[ $to == 2 ]] ;;
    2.0) [[ $to == 2.6 || $to == 1.4 ]] ;;
    4e-3) [[ $to == 0.0052 || $to == 0.0028 ]] ;;
    1.5) [[ $to == 1.95 || $to == 1.05 ]] ;;
  esac || fail "$from becomes $to"
done < list.txt
expectEqual "$(list)" "$(cat list.txt)" "a second time"
# The column is where it stands.
while IFS=$'\t' read -r _ file row column from _; do
  line=$(sed -n "${row}p" "$file")
  [[ $from == "${line:column-1:${#from}}" ]] || [[ $from == "$(sed 's/^ *//; s/ *$//' <<< "${line:column-1:4}")" ]] || fail "$file:$row:$column is not '$from'"
done < list.txt
cd "$root" || exit 1
expectError 2 "mutation.sh: no folder src/walkin" scripts/mutation.sh walkin
[[ $(SEED=3 OPERATORS=5 scripts/mutation.sh --list optimization) == "$(SEED=3 OPERATORS=5 scripts/mutation.sh --list optimization)" ]] || fail "the same seed chooses others"
