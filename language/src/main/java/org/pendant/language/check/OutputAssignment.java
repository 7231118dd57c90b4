package org.pendant.language.check;

import java.util.List;
import java.util.Optional;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Index;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Statement.Assign;

/**
 * Output assignment: {@code digital_out[n] = True}, which client programs send to robots: it sets
 * an output where the program has no variable of that name.
 */
public final class OutputAssignment {
  private static final String NAME = "digital_out";

  /** How messages name such an assignment. */
  static final String WRITTEN = NAME + "[n] = ...";

  /** What a call in its place would have behind its name. */
  static final String ARGUMENTS = "(n, ...)";

  private static final String FUNCTION = "set_digital_out";

  private OutputAssignment() {}

  /** The call that {@code assign} stands for; empty for any other assignment. */
  public static Optional<Expression.Call> call(Assign assign, FunctionScope scope) {
    boolean output =
        assign.target() instanceof Index index
            && index.indices().size() == 1
            && index.receiver() instanceof Name(String name, _)
            && name.equals(NAME)
            && !scope.knows(name);
    if (!output) {
      return Optional.empty();
    }
    Index target = (Index) assign.target();
    return Optional.of(
        new Expression.Call(
            FUNCTION,
            target.receiver().range(),
            List.of(argument(target.indices().getFirst()), argument(assign.value())),
            assign.range()));
  }

  private static Argument argument(Expression value) {
    return new Argument(Optional.empty(), value, value.range());
  }
}
