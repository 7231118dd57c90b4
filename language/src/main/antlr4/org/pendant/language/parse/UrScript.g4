/*
 * URScript (manual 3 to 13). Every decision is taken on one token, so a program is read in linear
 * time and ANTLR's prediction engine is never entered; keep it so.
 *
 * Line ends are white space. Where one matters, the token pass in front of the parser says so with
 * token types of its own, which no lexer rule makes:
 *   LINE_LPAREN LINE_LBRACK LINE_PLUS LINE_MINUS   first on their line outside brackets: they begin
 *                                                  an operand but never continue an expression
 *   BARE_RETURN                                    a return with nothing after it on its line
 * It also turns a reserved word behind a dot into a NAME: `time().sec`, `server.run()`.
 *
 * Operators stand in one flat list; the tree builder sorts them by precedence.
 */
grammar UrScript;

tokens { LINE_LPAREN, LINE_LBRACK, LINE_PLUS, LINE_MINUS, BARE_RETURN }

script
    : statement* EOF
    ;

block
    : statement*
    ;

// `tree` is what the builder made of it; nothing for a statement with an error.
statement
locals [java.util.Optional<org.pendant.language.syntax.Statement> tree = java.util.Optional.empty()]
    : effect
    | (GLOBAL | LOCAL) NAME ASSIGN expression
    | conditional
    | loop
    | definition
    | RETURN expression
    | BARE_RETURN
    | BREAK
    | CONTINUE
    | HALT
    | PAUSE
    | JOIN expression
    | KILL expression
    | ENTER_CRITICAL
    | EXIT_CRITICAL
    | LABEL
    ;

// A call, `run`, or an assignment; the builder refuses the rest.
effect
    : reference (ASSIGN expression)?
    ;

reference
    : NAME arguments? suffix*
    | RUN NAME arguments
    ;

conditional
    : IF condition COLON block alternative* (ELSE COLON block)? END
    ;

alternative
    : ELIF condition COLON block
    ;

loop
    : WHILE condition COLON block END
    ;

condition
    : expression
    ;

definition
    : (DEF | SEC | THREAD) head COLON block END
    ;

head
    : NAME LPAREN (parameter (COMMA parameter)*)? RPAREN
    ;

parameter
    : NAME (ASSIGN expression)?
    ;

// prefix* operand (operator prefix* operand)*
expression
    : (NOT | BANG | MINUS | PLUS | LINE_MINUS | LINE_PLUS)* operand
      ( ( OR | XOR | AND
        | EQUAL | NOT_EQUAL | LESS | GREATER | LESS_OR_EQUAL | GREATER_OR_EQUAL
        | PLUS | MINUS | STAR | SLASH | PERCENT
        )
        (NOT | BANG | MINUS | PLUS | LINE_MINUS | LINE_PLUS)* operand
      )*
    ;

operand
    : NAME arguments? suffix*
    | (INT | FLOAT | STRING | TRUE | FALSE | NONE) suffix*
    | (LPAREN | LINE_LPAREN) expression RPAREN suffix*
    | (LBRACK | LINE_LBRACK) (expression (COMMA expression)*)? RBRACK suffix*
    | RUN NAME arguments
    ;

suffix
    : DOT NAME arguments?
    | LBRACK (expression (COMMA expression)*)? RBRACK
    ;

arguments
    : LPAREN (argument (COMMA argument)*)? RPAREN
    ;

// `name = value` or a value alone; the builder sees to it that the left side is a name.
argument
    : expression (ASSIGN expression)?
    ;

// Reserved words, DEF first and NONE last.
DEF: 'def';
SEC: 'sec';
THREAD: 'thread';
END: 'end';
IF: 'if';
ELIF: 'elif';
ELSE: 'else';
WHILE: 'while';
BREAK: 'break';
CONTINUE: 'continue';
RETURN: 'return';
HALT: 'halt';
PAUSE: 'pause';
RUN: 'run';
JOIN: 'join';
KILL: 'kill';
ENTER_CRITICAL: 'enter_critical';
EXIT_CRITICAL: 'exit_critical';
GLOBAL: 'global';
LOCAL: 'local';
AND: 'and';
OR: 'or';
XOR: 'xor';
NOT: 'not';
TRUE: 'True';
FALSE: 'False';
NONE: 'None';

NAME: [A-Za-z_] [A-Za-z_0-9]*;
FLOAT
    : [0-9]+ '.' [0-9]* EXPONENT?
    | '.' [0-9]+ EXPONENT?
    | [0-9]+ EXPONENT
    ;
fragment EXPONENT: [eE] [+-]? [0-9]+;
INT: [0-9]+;

// Bytes, no escapes, one line.
STRING: '"' ~["\r\n]* '"';

// The rest of its line, wherever it stands; the token pass refuses one that is not first.
LABEL: '$' ~[\r\n]*;

LPAREN: '(';
RPAREN: ')';
LBRACK: '[';
RBRACK: ']';
COMMA: ',';
COLON: ':';
DOT: '.';
ASSIGN: '=';
EQUAL: '==';
NOT_EQUAL: '!=';
LESS: '<';
GREATER: '>';
LESS_OR_EQUAL: '<=';
GREATER_OR_EQUAL: '>=';
PLUS: '+';
MINUS: '-';
STAR: '*';
SLASH: '/';
PERCENT: '%';
BANG: '!';

BLANK: [ \t\r\n\f\u000B]+ -> skip;
COMMENT: '#' ~[\r\n]* -> skip;

// What people write out of habit from other languages; named so that messages can be exact.
OPEN_STRING: '"' ~["\r\n]*;
SINGLE_QUOTED: '\'' ~['\r\n]* '\'';
SEMICOLON: ';';
ARITHMETIC_ASSIGN: '+=' | '-=' | '*=' | '/=' | '%=';
COLON_ASSIGN: ':=';
DOUBLE_AMPERSAND: '&&';
DOUBLE_BAR: '||';
ANGLES: '<>';
SLASH_COMMENT: '//' ~[\r\n]*;

// Anything else: bytes that are not ASCII arrive here as \u007F, in runs.
STRANGE: [\u0000-\u0008\u000E-\u001F\u007F]+ | .;
