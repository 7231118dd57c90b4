package org.pendant.testing.source;

import java.util.Optional;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.StringLiteral;
import org.pendant.testing.builtin.MockBuiltins;
import org.pendant.testing.builtin.ProcedureBuiltins;

/**
 * Answering function: that a function of a test file answers in place of another one, as a call of
 * {@code mock_by} says, or for a remote procedure.
 *
 * @param function what it answers for
 * @param by its name
 * @param remote whether it answers for a remote procedure
 * @param byRange where its name stands
 * @param range of the call
 */
record AnsweringFunction(
    String function, String by, boolean remote, SourceRange byRange, SourceRange range) {

  /** What a call says; empty for other calls, and where a name is not written in quotes. */
  static Optional<AnsweringFunction> of(Call call) {
    return says(call)
            && call.arguments().size() == 2
            && call.arguments().get(0).value() instanceof StringLiteral function
            && call.arguments().get(1).value() instanceof StringLiteral by
        ? Optional.of(
            new AnsweringFunction(
                function.value(),
                by.value(),
                call.function().equals(ProcedureBuiltins.RPC_ANSWER_BY),
                by.range(),
                call.range()))
        : Optional.empty();
  }

  /** Whether a call is one that says so, well written or not. */
  static boolean says(Call call) {
    return call.function().equals(MockBuiltins.MOCK_BY)
        || call.function().equals(ProcedureBuiltins.RPC_ANSWER_BY);
  }
}
