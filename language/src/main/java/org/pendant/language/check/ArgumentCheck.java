package org.pendant.language.check;

import static org.pendant.language.check.CheckTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.signature.Parameter;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression.BoolLiteral;

/** Argument check: compares the arguments of a call with the head of what is called. */
final class ArgumentCheck {
  /** Functions with this parameter wait only when it is set. */
  private static final String BLOCKING = "blocking";

  private final CheckRun run;
  private final ExpressionCheck expressions;
  private final FunctionState state;

  ArgumentCheck(CheckRun run, ExpressionCheck expressions, FunctionState state) {
    this.run = run;
    this.expressions = expressions;
    this.state = state;
  }

  void check(FunctionHead head, List<Argument> arguments, SourceRange nameRange) {
    int count = head.parameters().size();
    boolean[] given = new boolean[count];
    boolean tooMany = false;
    boolean named = false;
    boolean unclear = false;
    for (int i = 0; i < arguments.size(); i++) {
      Argument argument = arguments.get(i);
      StaticType kind = expressions.check(argument.value());
      int position;
      if (argument.name().isPresent()) {
        named = true;
        position = position(head, argument.name().get(), argument.range());
        unclear |= position < 0;
      } else if (named) {
        positionalAfterNamed(argument);
        position = -1;
        unclear = true;
      } else {
        position = i < count ? i : -1;
        if (i >= count && !tooMany) {
          tooMany = true;
          tooMany(head, arguments.size(), argument.range());
        }
      }
      if (position >= 0) {
        accept(head, position, given, argument, kind);
      }
    }
    if (!unclear) {
      reportMissing(head, given, nameRange);
    }
  }

  /** {@code struct(a = 1, b = 2)}: every argument names a member (manual 4.1). */
  void checkStruct(List<Argument> arguments, SourceRange nameRange) {
    Set<String> members = new HashSet<>();
    for (Argument argument : arguments) {
      expressions.check(argument.value());
      if (argument.name().isEmpty()) {
        run.findings()
            .error("struct-arguments", argument.range(), text("structArgumentWithoutName"));
      } else if (!members.add(argument.name().get())) {
        duplicate("struct", argument.name().get(), argument.range());
      }
    }
    if (arguments.isEmpty()) {
      run.findings().error("struct-arguments", nameRange, text("structWithoutMembers"));
    }
  }

  void positionalAfterNamed(Argument argument) {
    run.findings().error("positional-after-named", argument.range(), text("positionalAfterNamed"));
  }

  private int position(FunctionHead head, String name, SourceRange range) {
    Integer position = head.positions().get(name);
    if (position != null) {
      return position;
    }
    Optional<String> near = run.nearest(name, head.positions()::keySet);
    run.findings()
        .error(
            "unknown-argument",
            range,
            near.isPresent()
                ? text("noParameterDidYouMean", head.name(), name, near.get(), head.text())
                : text("noParameter", head.name(), name, head.text()));
    return -1;
  }

  private void accept(
      FunctionHead head, int position, boolean[] given, Argument argument, StaticType kind) {
    Parameter parameter = head.parameters().get(position);
    if (given[position]) {
      duplicate(head.name(), parameter.name(), argument.range());
    }
    given[position] = true;
    if (!kind.fits(parameter.type())) {
      run.findings()
          .error(
              "type-mismatch",
              argument.range(),
              text(
                  "argumentType",
                  head.name(),
                  parameter.name(),
                  kind.text(),
                  parameter.type().text()));
    }
    boolean off = argument.value() instanceof BoolLiteral(boolean value, _) && !value;
    if (parameter.name().equals(BLOCKING) && !off) {
      state.waits();
    }
  }

  private void duplicate(String function, String name, SourceRange range) {
    run.findings().error("duplicate-argument", range, text("argumentGivenTwice", function, name));
  }

  private void tooMany(FunctionHead head, int found, SourceRange range) {
    run.findings()
        .error(
            "too-many-arguments", range, text("tooManyArguments", head.name(), found, head.text()));
  }

  private void reportMissing(FunctionHead head, boolean[] given, SourceRange nameRange) {
    List<String> missing = new ArrayList<>();
    for (int i = 0; i < given.length; i++) {
      if (!given[i] && head.parameters().get(i).required()) {
        missing.add(head.parameters().get(i).name());
      }
    }
    if (!missing.isEmpty()) {
      run.failsWhenItRuns(
          "missing-argument",
          nameRange,
          text("calledWithout", head.name(), String.join(", ", missing), head.text()));
    }
  }
}
