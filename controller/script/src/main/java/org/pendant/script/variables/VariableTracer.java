package org.pendant.script.variables;

import static org.pendant.script.variables.TracedVariableTexts.text;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.script.vm.Machine;
import org.pendant.script.vm.VariableSlots;

/**
 * Variable tracer: reads chosen numbers out of the running or last program, in every frame. Each of
 * those who want some has a list of its own. Frame loop only.
 */
public final class VariableTracer {
  /** Most numbers, of all lists together. */
  public static final int MOST = 64;

  private final Machine machine;
  private final Map<String, List<VariablePath>> wanted = new LinkedHashMap<>();
  private List<VariablePath> paths = List.of();
  private PathReader[] readers = new PathReader[0];
  private TracedVariables.Names names = new TracedVariables.Names(List.of());
  private double[] scratch = new double[0];
  private TracedVariables traced = TracedVariables.NONE;

  private Optional<VariableSlots> bound = Optional.empty();
  private final int[] globals = new int[MOST];
  private final int[] locals = new int[MOST];

  /** Traces what {@code machine} runs. */
  public VariableTracer(Machine machine) {
    this.machine = machine;
  }

  /**
   * Traces {@code list} for {@code owner}, in place of what it wanted before.
   *
   * @param owner a name that only one uses, such as {@code plots}
   * @throws IllegalArgumentException if that would be more than {@link #MOST} together; nothing has
   *     changed
   */
  public void trace(String owner, List<VariablePath> list) {
    Set<VariablePath> together = new LinkedHashSet<>();
    wanted.forEach(
        (other, theirs) -> {
          if (!other.equals(owner)) {
            together.addAll(theirs);
          }
        });
    together.addAll(list);
    if (together.size() > MOST) {
      throw new IllegalArgumentException(text("tooManyTraced", together.size(), MOST));
    }
    if (list.isEmpty()) {
      wanted.remove(owner);
    } else {
      wanted.put(owner, List.copyOf(list));
    }
    paths = List.copyOf(together);
    readers = paths.stream().map(PathReader::new).toArray(PathReader[]::new);
    names = new TracedVariables.Names(paths.stream().map(VariablePath::text).toList());
    scratch = new double[readers.length];
    traced =
        paths.isEmpty()
            ? TracedVariables.NONE
            : TracedVariables.owning(names, new double[readers.length]);
    bound = Optional.empty();
  }

  /** The numbers as they are now; makes one array when one of them has changed. */
  public TracedVariables read() {
    if (readers.length == 0) {
      return TracedVariables.NONE;
    }
    Optional<VariableSlots> slots = machine.variableSlots();
    if (slots.isEmpty()) {
      Arrays.fill(scratch, Double.NaN);
    } else {
      bind(slots.get());
      read(slots.get());
    }
    if (!traced.hasValues(scratch)) {
      traced = TracedVariables.owning(names, scratch.clone());
    }
    return traced;
  }

  private void read(VariableSlots slots) {
    int firstLocal = slots.firstLocal();
    for (int i = 0; i < readers.length; i++) {
      if (globals[i] != VariableSlots.NONE) {
        scratch[i] = readers[i].read(slots.registers(), globals[i]);
      } else if (locals[i] != VariableSlots.NONE && firstLocal != VariableSlots.NONE) {
        scratch[i] = readers[i].read(slots.registers(), firstLocal + locals[i]);
      } else {
        scratch[i] = Double.NaN;
      }
    }
  }

  /** Looks the names up, once for each run of a program. */
  private void bind(VariableSlots slots) {
    if (bound.isPresent() && bound.get() == slots) {
      return;
    }
    bound = Optional.of(slots);
    for (int i = 0; i < paths.size(); i++) {
      String name = paths.get(i).name();
      int global = slots.globals().indexOf(name);
      globals[i] = global < 0 ? VariableSlots.NONE : slots.global(global);
      locals[i] = slots.locals().indexOf(name);
    }
  }
}
