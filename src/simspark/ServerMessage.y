/* The server's message to an agent. Known nodes fill a ServerMessage through the builder; a node it does not know
   is skipped whole, at the top and inside known ones. An opening parenthesis and the word behind it are one token,
   so that a team may be called "See" and a message heard "self". */
%define api.prefix {serverMessage}
%define api.pure full
%define parse.error verbose
%lex-param {void* scanner}
%parse-param {void* scanner} {plumbline::simspark::ServerMessageBuilder& builder}

%code requires {
#include <string_view>
#include "simspark/ServerMessageBuilder.h"
/* A word of the text, as plain data for the parser's union. */
struct ServerMessageWord {
  const char* begin;
  int size;
  operator std::string_view() const { return {begin, static_cast<std::size_t>(size)}; }
};
}
%define api.value.type {ServerMessageWord}

%code {
int serverMessagelex(ServerMessageWord* value, void* scanner);
static void serverMessageerror(void*, plumbline::simspark::ServerMessageBuilder& builder, const char* what) {
  builder.fail(what);
}
#define NUMBER(word) builder.number(word)
#define CHECK if (builder.failed()) YYABORT
}

%token WORD "word" CLOSE ")"
%token OTHER "(name"
%token TIME "(time" NOW "(now" GS "(GS" UNUM "(unum" TEAM "(team" SL "(sl" SR "(sr" T "(t" PM "(pm" HEAR "(hear"
%token GYR "(GYR" RT "(rt" ACC "(ACC" A "(a" N "(n" HJ "(HJ" AX "(ax" FRP "(FRP" C "(c" F "(f"
%token SEE "(See" P "(P" L "(L" POL "(pol" ID "(id"
%token GT "(GT" MYPOS "(mypos" POSE "(pose" UP "(up" Z "(z" FORWARD "(forward" B "(B"

%%

message: %empty | message node { CHECK; };

node: TIME timeFields CLOSE
    | GS gsFields CLOSE
    | HEAR WORD WORD WORD WORD CLOSE { builder.hear($2, $3, $4, $5); }
    | HEAR WORD WORD WORD CLOSE { builder.hear({}, $2, $3, $4); }
    | GYR gyrFields CLOSE
    | ACC accFields CLOSE
    | HJ hjFields CLOSE { builder.closeHingeJoint(); }
    | FRP frpFields CLOSE { builder.closeForce(); }
    | SEE { builder.openSee(); } seeFields CLOSE
    | GT { builder.openGroundTruth(); } gtFields CLOSE { builder.closeGroundTruth(); }
    | other
    ;

timeFields: %empty | timeFields timeField;
timeField: NOW WORD CLOSE { builder.message.time = NUMBER($2); } | other;

gsFields: %empty | gsFields gsField;
gsField: UNUM WORD CLOSE { builder.message.gameState.unum = builder.integer($2); }
       | TEAM WORD CLOSE { builder.message.gameState.side = std::string($2); }
       | SL WORD CLOSE { builder.message.gameState.scoreLeft = builder.integer($2); }
       | SR WORD CLOSE { builder.message.gameState.scoreRight = builder.integer($2); }
       | T WORD CLOSE { builder.message.gameState.time = NUMBER($2); }
       | PM WORD CLOSE { builder.message.gameState.playMode = std::string_view($2); }
       | other
       ;

gyrFields: %empty | gyrFields gyrField;
gyrField: N WORD CLOSE
        | RT WORD WORD WORD CLOSE { builder.gyro(NUMBER($2), NUMBER($3), NUMBER($4)); }
        | other
        ;

accFields: %empty | accFields accField;
accField: N WORD CLOSE
        | A WORD WORD WORD CLOSE { builder.acc(NUMBER($2), NUMBER($3), NUMBER($4)); }
        | other
        ;

hjFields: %empty | hjFields hjField;
hjField: N WORD CLOSE { builder.name($2); }
       | AX WORD CLOSE { builder.angle(NUMBER($2)); }
       | other
       ;

frpFields: %empty | frpFields frpField;
frpField: N WORD CLOSE { builder.name($2); }
        | C WORD WORD WORD CLOSE { builder.point(NUMBER($2), NUMBER($3), NUMBER($4)); }
        | F WORD WORD WORD CLOSE { builder.force(NUMBER($2), NUMBER($3), NUMBER($4)); }
        | other
        ;

seeFields: %empty | seeFields seeField { CHECK; };
seeField: OTHER objectFields CLOSE { builder.closeObject($1); }
        | B objectFields CLOSE { builder.closeObject($1); }
        | F objectFields CLOSE { builder.closeObject($1); }
        | P { builder.openPlayer(); } playerFields CLOSE
        | L objectFields CLOSE { builder.closeLine(); }
        | MYPOS objectFields CLOSE
        ;

objectFields: %empty | objectFields objectField;
objectField: POL WORD WORD WORD CLOSE { builder.polar($2, $3, $4); }
           | WORD
           | other
           ;

playerFields: %empty | playerFields playerField;
playerField: TEAM WORD CLOSE { builder.player().team = std::string_view($2); }
           | ID WORD CLOSE { builder.player().unum = builder.integer($2); }
           | OTHER objectFields CLOSE { builder.closePart($1); }
           ;

gtFields: %empty | gtFields gtField;
gtField: MYPOS myposFields CLOSE
       | B OTHER WORD WORD CLOSE CLOSE {  /* (B (x y z)): the first number sits behind its parenthesis */
           builder.truth().ball = plumbline::Vec3(NUMBER($2), NUMBER($3), NUMBER($4)); }
       | P { builder.openTruePlayer(); } truePlayerFields CLOSE
       | other
       ;

myposFields: %empty | myposFields myposField;
myposField: POSE WORD WORD WORD CLOSE {
              builder.truth().T_world_torso.translation().x() = NUMBER($2);
              builder.truth().T_world_torso.translation().y() = NUMBER($3); }
          | UP WORD WORD WORD CLOSE { builder.up(NUMBER($2), NUMBER($3), NUMBER($4)); }
          | Z WORD CLOSE { builder.truth().T_world_torso.translation().z() = NUMBER($2); }
          | FORWARD WORD WORD WORD CLOSE { builder.forward(NUMBER($2), NUMBER($3), NUMBER($4)); }
          | other
          ;

truePlayerFields: %empty | truePlayerFields truePlayerField;
truePlayerField: TEAM WORD CLOSE { builder.truePlayer().team = std::string_view($2); }
               | ID WORD CLOSE { builder.truePlayer().unum = builder.integer($2); }
               | POSE WORD WORD WORD CLOSE {
                   builder.truePlayer().x = NUMBER($2);
                   builder.truePlayer().y = NUMBER($3);
                   builder.truePlayer().heading = NUMBER($4); }
               | other
               ;

other: OTHER skipped CLOSE;
skipped: %empty | skipped WORD | skipped anyOpen skipped CLOSE;
anyOpen: OTHER | TIME | NOW | GS | UNUM | TEAM | SL | SR | T | PM | HEAR | GYR | RT | ACC | A | N | HJ | AX | FRP | C
       | F | SEE | P | L | POL | ID | GT | MYPOS | POSE | UP | Z | FORWARD | B;

%%
