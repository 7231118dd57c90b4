package org.pendant.script.vm;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.function.IntPredicate;
import org.pendant.language.source.Source;

/**
 * Breakpoint patches of one run. A function with breakpoints is exchanged for a patched copy, which
 * is always interpreted; all other functions keep their speed, and so do other runs of the same
 * program.
 */
final class BreakpointPatches {
  /**
   * Which statements have traps.
   *
   * @param starts statements of the program's text, by their first offset
   * @param whole functions with a trap before every statement, as they were compiled
   * @param everywhere whether all functions have
   * @param lines whether lines of interpreter mode have that are yet to run
   */
  record Plan(Set<Integer> starts, Set<ScriptFunction> whole, boolean everywhere, boolean lines) {
    static final Plan NONE = new Plan(Set.of(), Set.of(), false, false);

    Plan {
      starts = Set.copyOf(starts);
      whole = Set.copyOf(whole);
    }
  }

  private final Source source;
  private final IdentityHashMap<ScriptFunction, ScriptFunction> forms = new IdentityHashMap<>();

  /** The form that the plan asks for; made when a function is first looked at. */
  private final IdentityHashMap<ScriptFunction, ScriptFunction> chosen = new IdentityHashMap<>();

  private Plan plan = Plan.NONE;
  private boolean unsettled;

  /**
   * @param source the text of the program
   */
  BreakpointPatches(Source source) {
    this.source = source;
  }

  /** Changes to {@code plan}, in the functions that can be called and in those under way. */
  void set(Plan plan, ScriptFunction[] functions, List<ScriptThread> threads) {
    this.plan = plan;
    chosen.clear();
    forms.values().forEach(form -> form.trap(statement -> false));
    replaceIn(functions);
    for (ScriptThread thread : threads) {
      for (int i = 0; i < thread.depth; i++) {
        ScriptFunction original = thread.functions[i].original();
        if (form(original) != original) {
          thread.functions[i] = form(original);
        } else {
          // a translation could not continue from where a trap has stopped it
          unsettled |= thread.functions[i] != original;
        }
      }
    }
  }

  /** Whether a function may have traps. */
  boolean wanted() {
    return !plan.equals(Plan.NONE);
  }

  /** Exchanges the functions that can be called. */
  void replaceIn(ScriptFunction[] functions) {
    if (plan.equals(Plan.NONE) && forms.isEmpty()) {
      return;
    }
    for (int i = 0; i < functions.length; i++) {
      functions[i] = form(functions[i].original());
    }
  }

  /** The form of an interpreted line that is about to run. */
  ScriptFunction entered(ScriptFunction line) {
    return plan.lines() ? trapped(line, statement -> true) : line;
  }

  /** Lets functions under way continue as they were compiled if they have no traps any more. */
  void settle(List<ScriptThread> threads) {
    if (!unsettled) {
      return;
    }
    unsettled = false;
    for (ScriptThread thread : threads) {
      for (int i = 0; i < thread.depth; i++) {
        ScriptFunction original = thread.functions[i].original();
        thread.functions[i] = form(original);
      }
    }
  }

  private ScriptFunction form(ScriptFunction original) {
    ScriptFunction form = chosen.get(original);
    if (form != null) {
      return form;
    }
    StatementTable statements = original.statements();
    for (int i = 0; i < statements.size(); i++) {
      if (wanted(original, i)) {
        return trapped(original, statement -> wanted(original, statement));
      }
    }
    chosen.put(original, original);
    return original;
  }

  private ScriptFunction trapped(ScriptFunction original, IntPredicate statements) {
    ScriptFunction form = forms.computeIfAbsent(original, ScriptFunction::trappedForm);
    form.trap(statements);
    chosen.put(original, form);
    return form;
  }

  private boolean wanted(ScriptFunction original, int statement) {
    return plan.everywhere()
        || plan.whole().contains(original)
        || (fromText(original) && plan.starts().contains(original.statements().start(statement)));
  }

  private boolean fromText(ScriptFunction function) {
    return function.source() == source;
  }
}
