package org.pendant.script.variables;

import java.util.List;
import java.util.Optional;

/**
 * Variable samples: the variables of the running or last program, for readers that need not see
 * every frame: taken about 25 times a second of robot time, and when the program ends. Immutable,
 * the same object as long as nothing changes, and bounded: see {@link VariableSampler}.
 *
 * @param run counts the programs that were started, from 1; 0 before the first
 * @param globals in the order of their first assignment, those without a value yet included
 * @param mainFunction the function whose variables the {@code locals} are; empty text for most
 *     programs, whose own function has no locals: every variable of the first level is global
 *     (manual 9)
 * @param locals of the call of that function, parameters first; empty while it is not under way
 * @param omitted how many variables there are beyond these
 */
public record VariableSamples(
    long run,
    List<VariableSample> globals,
    String mainFunction,
    List<VariableSample> locals,
    int omitted) {
  /** Before the first program. */
  public static final VariableSamples NONE = new VariableSamples(0, List.of(), "", List.of(), 0);

  public VariableSamples {
    globals = List.copyOf(globals);
    locals = List.copyOf(locals);
  }

  /** Whether there is nothing to show. */
  public boolean empty() {
    return globals.isEmpty() && locals.isEmpty();
  }

  /** The part of a variable that {@code path} means, if the sample has it; globals first. */
  public Optional<VariableSample> find(VariablePath path) {
    Optional<VariableSample> found = find(path, globals);
    return found.isPresent() ? found : find(path, locals);
  }

  private static Optional<VariableSample> find(VariablePath path, List<VariableSample> among) {
    return among.stream()
        .filter(each -> each.name().equals(path.name()))
        .findFirst()
        .flatMap(each -> each.part(path.steps()));
  }
}
