package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.script.value.Registers;

/**
 * Variable slots: where one run of a program keeps its variables, for readers that look at them
 * often. Looking makes nothing and changes nothing. Frame loop only; the values stay when the
 * program has ended.
 */
public final class VariableSlots {
  /** In place of a slot: the variable is not there now. */
  public static final int NONE = -1;

  private final ProgramRun run;
  private final List<String> globals;
  private final int[] globalSlots;
  private final Optional<ScriptFunction> mainFunction;

  VariableSlots(ProgramRun run) {
    this.run = run;
    Map<String, Integer> slots = run.globalSlots();
    List<String> names = new ArrayList<>(run.program().globals());
    names.removeIf(name -> !slots.containsKey(name));
    globals = List.copyOf(names);
    globalSlots = globals.stream().mapToInt(slots::get).toArray();
    Program program = run.program();
    mainFunction =
        program.mainFunction().isPresent()
            ? Optional.of(program.tables().functions().get(program.mainFunction().getAsInt()))
            : Optional.empty();
  }

  /** The global variables, in the order of their first assignment. */
  public List<String> globals() {
    return globals;
  }

  /** The slot of global variable {@code number}. */
  public int global(int number) {
    return globalSlots[number];
  }

  /**
   * The name of the function that the last line of the program calls; empty for a program whose own
   * function is its first level, where every variable is global.
   */
  public String mainFunction() {
    return mainFunction.map(ScriptFunction::name).orElse("");
  }

  /** The parameters and local variables of the {@link #mainFunction}, in the order of slots. */
  public List<String> locals() {
    return mainFunction.map(ScriptFunction::variables).orElse(List.of());
  }

  /**
   * The slot of the first local variable, which the others follow; {@link #NONE} while that
   * function is not under way.
   */
  public int firstLocal() {
    if (mainFunction.isEmpty()) {
      return NONE;
    }
    ScriptThread main = run.main();
    boolean underWay = main.depth > 1 && main.functions[1].original() == mainFunction.get();
    return underWay ? main.bases[1] : NONE;
  }

  /** What the slots are in. */
  public Registers registers() {
    return run.registers();
  }
}
