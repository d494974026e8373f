#!/usr/bin/env bash
# What scripts/mutation.sh changes: numbers of constants and of comparisons in walk and diagnosis, operators elsewhere;
# nothing in comments, texts and types. Then, that a source with all changes behind switches computes as before, and that
# each switch changes one place, and notes who reaches it.
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
list() { awk -v thresholds='^src/(walking|gap)/' -f "$root/scripts/mutation/code.awk" -f "$root/scripts/mutation/list.awk" src/gap/Limits.cpp src/robot/Arm.cpp; }
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

# All changes of a program at once.
mkdir -p src/gap src/tool
cat > src/gap/Main.cpp << 'CPP'
#include <cstdio>
#include <array>
namespace {
constexpr double share = 0.5;
constexpr double twice = 2 * share;
constexpr std::array<int, 3> sizes = {4, 5,
                                      6};
constexpr double unused = 0.25;
double local(double x) {
  static constexpr double most = 8.0;
  return x > 1.5 ? most : twice;
}
}
int sum(int a, int b);
int main() {
  std::printf("%g %g %d %d\n", local(1), local(2), sizes[2], sum(7, 5));
  for (int n = 0; n < 40; ++n) if (mutation::ran[n]) std::printf("%d ", n);
}
CPP
cat > src/tool/Sum.cpp << 'CPP'
#include <algorithm>
#include <string>
int sum(int a, int b) {
  const std::string text = std::string("(") + std::to_string(a) + ")";
  const int all = std::max(a, 0) + b * 2;
  return a <= b || a == 3 ? 0 : all - static_cast<int>(text.size()) + 3;
}
CPP
code="-f $root/scripts/mutation/code.awk"
awk -v thresholds='^src/gap/' $code -f "$root/scripts/mutation/list.awk" src/gap/Main.cpp src/tool/Sum.cpp |
  awk -F'\t' -v OFS='\t' '{ print NR, $5 ~ /\|\|/ || $2 $3 ~ /Sum.cpp4/ ? "own" : $3 == 10 ? "member" : "plain", $0 }' > plan.txt
echo '#' > keep.txt
for file in gap/Main tool/Sum; do
  awk -v header="$root/scripts/mutation/Switches.h" -v reached=reached.txt $code -f "$root/scripts/mutation/switches.awk" plan.txt keep.txt src/$file.cpp > "${file#*/}.cpp"
done
g++ -std=c++20 -w Main.cpp Sum.cpp -o main || fail "what has switches does not compile"
expectEqual "$(./main | head -n 1)" "1 8 6 17" "with no switch"
expectEqual "$(./main | tail -n +2 | tr " " "\n" | grep .)" "$(awk -F"\t" "\$2 != \"own\" && \$7 != 0.25 { print \$1 }" plan.txt)" "the places that were reached"
numberOf() { awk -F'\t' -v at="$1" '$4 ":" $5 ":" $7 == at { print $1 }' plan.txt; }
with() { PLUMBLINE_MUTANT=$(numberOf "$1") ./main | head -n 1; }
expectEqual "$(with src/gap/Main.cpp:4:0.5 | sed 's/ .*//')" "$(awk -F'\t' '$7 == 0.5 { print 2 * $8 }' plan.txt)" "a constant, by way of another"
expectEqual "$(with src/gap/Main.cpp:10:8.0 | cut -d' ' -f2)" "$(awk -F'\t' '$7 == "8.0" { print $8 + 0 }' plan.txt)" "a constant of a function"
expectEqual "$(with src/gap/Main.cpp:7:6 | cut -d' ' -f3)" "$(awk -F'\t' '$7 == 6 { print $8 }' plan.txt)" "a number of several"
expectEqual "$(with 'src/tool/Sum.cpp:5:std::max(' | cut -d' ' -f4)" "10" "the least for the most"
expectEqual "$(with 'src/tool/Sum.cpp:5: * ' | cut -d' ' -f4)" "9" "/ for *"
expectEqual "$(with 'src/tool/Sum.cpp:6: - ' | cut -d' ' -f4)" "23" "+ for -"

# Which tests a change is tried with: those that reach it, named ones first, slow ones last; all where that is not known.
cd "$scratch" || exit 1
printf '%s\t' @start 0 9 > record; echo >> record
for test in "Arm.bends 5 1 2" "Leg.walks 300 1" "Leg.stands 7 1" "Head.turns 3 2"; do tr ' ' '\t' <<< "$test" >> record; done
chosen() { awk -v number="$1" -v name=Arm -v own="${2-}" -v near="${3-}" -f "$root/scripts/mutation/select.awk" record | tr '\t\n' ' ;'; }
expectEqual "$(chosen 1)" "5 Arm.bends;7 Leg.stands;300 Leg.walks;" "tests that reach a place"
expectEqual "$(chosen 3)" "" "tests of a place that none reaches"
expectEqual "$(chosen 9 | tr ';' '\n' | wc -l)" 3 "tests of a place that is reached before the first"
expectEqual "$(chosen 4 yes "2 3" | cut -d';' -f1,2)" "5 Arm.bends;3 Head.turns" "tests of what is compiled by itself"
# What the compiler says is taken out of the plan.
printf '%s\n' "1 plain" "2 plain" "3 plain" "4 plain" | tr ' ' '\t' > plan
printf '%s\n' "src/a.cpp:1 constant 1" "src/a.cpp:1 place 1" "src/a.cpp:5 use 1" "src/a.cpp:7 place 2" "src/b.h:2 constant 3" "src/c.cpp:4 place 4" | tr ' ' '\t' > reached
dropped() { printf '%s\n' "$@" | awk -f "$root/scripts/mutation/drop.awk" plan reached - | LC_ALL=C sort | paste -sd';'; }
expectEqual "$(dropped "src/a.cpp:5:3: error: x")" "keep src/a.cpp:5" "a use that does not compile"
expectEqual "$(dropped "src/a.cpp:7:3: error: x" "src/a.cpp:1:1: note: y")" "own 2" "a place that does not compile"
expectEqual "$(dropped "src/a.cpp:1:3: error: x")" "member 1" "a constant that is none of a class"
expectEqual "$(dropped "src/d.cpp:9:1: error: x" "src/c.cpp:4:1: note: y")" "own 4" "a reason in a note"
expectEqual "$(dropped "src/b.h:8:1: error: the value of 'n' is not usable in a constant expression" \
  "src/b.h:2:1: note: 'n' was not initialized with a constant expression" "src/c.cpp:4:1: error: z")" "own 3;own 4" "a number that has to be known"
cd "$root" || exit 1
expectError 2 "mutation.sh: no folder src/walkin" scripts/mutation.sh walkin
[[ $(SEED=3 OPERATORS=5 scripts/mutation.sh --list optimization) == "$(SEED=3 OPERATORS=5 scripts/mutation.sh --list optimization)" ]] || fail "the same seed chooses others"
