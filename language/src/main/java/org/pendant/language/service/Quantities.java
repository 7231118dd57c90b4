package org.pendant.language.service;

import java.util.List;
import java.util.Optional;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.language.source.SourceRange;

/**
 * Quantity search: finds the unit of a number that stands alone as an argument, as a part of a
 * pose, or as one of the joint positions that a call takes.
 */
final class Quantities {
  private static final List<String> POSE_PARTS = List.of("x", "y", "z", "rx", "ry", "rz");
  private static final int LENGTHS = 3;

  private final ScriptAnalysis analysis;
  private final Lexemes lexemes;

  Quantities(ScriptAnalysis analysis) {
    this.analysis = analysis;
    lexemes = analysis.lexemes();
  }

  /** The number that holds {@code offset}, if its unit is known. */
  Optional<Quantity> at(int offset) {
    int index = lexemes.at(offset);
    if (index >= 0 && isSign(index)) {
      index++;
    }
    if (!lexemes.is(index, Kind.NUMBER) || !standsAlone(index)) {
      return Optional.empty();
    }
    int first = isSign(index - 1) ? index - 1 : index;
    int start = lexemes.get(first).start();
    SourceRange range = new SourceRange(start, lexemes.get(index).end());
    double size = Double.parseDouble(lexemes.text(index));
    double value = lexemes.reads(first, "-") ? -size : size;
    return CallPlace.around(lexemes, start + 1)
        .flatMap(
            place ->
                lexemes.reads(place.opener(), "[")
                    ? inList(place, range, value)
                    : argument(start + 1).flatMap(p -> quantity(range, value, p.unit(), p.name())));
  }

  private boolean isSign(int index) {
    return lexemes.is(index, Kind.OPERATOR)
        && (lexemes.reads(index, "-") || lexemes.reads(index, "+"))
        && index > 0
        && !lexemes.get(index - 1).endsOperand();
  }

  /** Whether nothing is computed with it. */
  private boolean standsAlone(int number) {
    int before = isSign(number - 1) ? number - 2 : number - 1;
    return switch (lexemes.kind(before)) {
      case OPEN, COMMA, ASSIGN -> ends(lexemes.kind(number + 1)) && number + 1 < lexemes.size();
      default -> false;
    };
  }

  private static boolean ends(Kind kind) {
    return kind == Kind.COMMA || kind == Kind.CLOSE;
  }

  private Optional<Quantity> inList(CallPlace place, SourceRange range, double value) {
    int bracket = place.opener();
    if (lexemes.reads(bracket - 1, "p")) {
      if (place.position() >= POSE_PARTS.size()) {
        return Optional.empty();
      }
      Unit unit = place.position() < LENGTHS ? Unit.METRE : Unit.RADIAN;
      return quantity(range, value, unit, POSE_PARTS.get(place.position()));
    }
    boolean whole =
        switch (lexemes.kind(bracket - 1)) {
          case OPEN, COMMA, ASSIGN -> ends(lexemes.kind(lexemes.close(bracket) + 1));
          default -> false;
        };
    Lexeme opener = lexemes.get(bracket);
    return whole
        ? argument(opener.start())
            .filter(p -> p.type() == Type.JOINTS || p.type() == Type.POSE_OR_JOINTS)
            .flatMap(
                p ->
                    quantity(
                        range,
                        value,
                        p.unit() == Unit.NONE ? Unit.RADIAN : p.unit(),
                        p.name() + "[" + place.position() + "]"))
        : Optional.empty();
  }

  /** The parameter of the innermost known call that is given at {@code offset}. */
  private Optional<Parameter> argument(int offset) {
    return CallPlace.around(lexemes, offset)
        .flatMap(
            call ->
                analysis
                    .callee(call)
                    .map(signature -> SignatureHelp.of(lexemes, call, signature))
                    .flatMap(SignatureHelp::activeParameter));
  }

  private static Optional<Quantity> quantity(
      SourceRange range, double value, Unit unit, String name) {
    return unit == Unit.NONE
        ? Optional.empty()
        : Optional.of(new Quantity(range, value, unit, name));
  }
}
