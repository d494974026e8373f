# Parsers: X.y makes X.tab.cpp and X.tab.h, X.l makes X.lex.cpp, each in build/generated/<folder of X>.
build/generated/%.tab.cpp build/generated/%.tab.h: %.y
	$(Q)$(call say,BISON,$<); mkdir -p $(@D); bison -d -Wall -Werror --file-prefix-map='$(CURDIR)/=' \
	  --defines=build/generated/$*.tab.h -o build/generated/$*.tab.cpp $<
build/generated/%.lex.cpp: %.l
	$(Q)$(call say,FLEX,$<); mkdir -p $(@D); flex -o $@ $<
