package org.pendant.language.service;

import java.util.Optional;
import java.util.Set;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.check.ValueTypes;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;

/**
 * Receiver: what is known about the value in front of a dot.
 *
 * @param type its type; ANY when not known
 * @param members the members of the struct that it holds, if the text shows them
 */
record Receiver(Type type, Set<String> members) {
  private static final Receiver UNKNOWN = new Receiver(Type.ANY, Set.of());

  /** The value that ends with lexeme {@code last}. */
  static Receiver of(ScriptAnalysis analysis, int last, FunctionScope scope) {
    Lexemes lexemes = analysis.lexemes();
    return switch (lexemes.kind(last)) {
      case NAME -> lexemes.is(last - 1, Kind.DOT) ? UNKNOWN : variable(analysis, last, scope);
      case CLOSE -> bracketed(analysis, last, scope);
      case STRING -> new Receiver(Type.STRING, Set.of());
      default -> UNKNOWN;
    };
  }

  private static Receiver variable(ScriptAnalysis analysis, int last, FunctionScope scope) {
    Lexeme lexeme = analysis.lexemes().get(last);
    String name = analysis.lexemes().text(last);
    ValueTypes types = analysis.types();
    Type type = types.variable(scope, scope.resolve(name, lexeme.start()));
    return new Receiver(type, analysis.index().members(analysis.variable(name, lexeme.start())));
  }

  /** A call, or a list or pose as it is written. */
  private static Receiver bracketed(ScriptAnalysis analysis, int last, FunctionScope scope) {
    Lexemes lexemes = analysis.lexemes();
    int open = lexemes.open(last);
    if (lexemes.reads(open, "(") && lexemes.is(open - 1, Kind.NAME)) {
      Optional<Signature> called = analysis.signatures().function(lexemes.text(open - 1), scope);
      Type result = called.map(Signature::result).orElse(Type.ANY);
      return new Receiver(isReceiver(result) ? result : Type.ANY, Set.of());
    }
    if (lexemes.reads(open, "[") && !lexemes.get(Math.max(0, open - 1)).endsOperand()) {
      return new Receiver(lexemes.reads(open + 1, "[") ? Type.MATRIX : Type.LIST, Set.of());
    }
    return UNKNOWN;
  }

  private static boolean isReceiver(Type type) {
    return switch (type) {
      case STRING, POSE, LIST, MATRIX, STRUCT, BOOL, RPC_HANDLE, EIP_HANDLE -> true;
      case ANY, NONE, INT, NUMBER, JOINTS, POSE_OR_JOINTS -> false;
    };
  }
}
