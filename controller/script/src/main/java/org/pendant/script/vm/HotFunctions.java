package org.pendant.script.vm;

import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.concurrent.atomic.AtomicReference;
import org.pendant.script.value.Registers;
import org.pendant.script.vm.Processor.Stop;

/**
 * Hot functions: finds the functions of one run that are worth a translation, and has them
 * translated without delaying the frame. A function that cannot be translated is interpreted.
 */
final class HotFunctions {
  /** Calls and turns after which a function is translated: a fraction of a millisecond's work. */
  private static final int HOT = 5000;

  /** Calls that could not be direct, which arguments that there is no code for count for. */
  private static final int CALLS_WITHOUT_CODE = 300;

  private static final int TURNS_UNTIL_LOOP = 64;

  /** Makes the translated form of a function. */
  interface Translating {
    Optional<TranslatedCode> translate(ScriptFunction function, Program.Tables tables);
  }

  private final Translation when;
  private final Program.Tables tables;
  private final Translating translator;

  /** A fault of the translator that was not reported. */
  private final AtomicReference<Throwable> fault = new AtomicReference<>();

  HotFunctions(Translation when, Program.Tables tables) {
    this(when, tables, Translator::translate);
  }

  /** With another translator, for tests. */
  HotFunctions(Translation when, Program.Tables tables, Translating translator) {
    this.when = when;
    this.tables = tables;
    this.translator = translator;
  }

  /** The code to run {@code function} with; null when it has to be interpreted. */
  TranslatedCode code(ScriptFunction function) {
    if (when == Translation.NEVER) {
      return null;
    }
    if (when == Translation.ALWAYS && function.translated() == null) {
      translate(function);
    }
    return function.translated();
  }

  /** Whether {@code function} must not be interpreted. */
  boolean translated(ScriptFunction function) {
    return code(function) != null;
  }

  /** Counts a turn or call of an interpreted function; whether it is better not interpreted. */
  boolean counts(ScriptFunction function) {
    if (when == Translation.WHEN_HOT && ++function.heat == HOT) {
      Thread.ofVirtual().name("translate " + function.name()).start(() -> translate(function));
    }
    return translated(function);
  }

  /**
   * Counts a turn of an interpreted function; {@link Stop#GOES_ON}, or why it is better not
   * interpreted any longer.
   */
  Stop turn(ScriptFunction function) {
    if (counts(function)) {
      return Stop.CALLED;
    }
    boolean looks =
        function.untranslatable
            && when != Translation.NEVER
            && function.heat % turnsUntilLoop() == 0;
    return looks ? Stop.TURNED : Stop.GOES_ON;
  }

  /**
   * What to call function {@code number} directly with for arguments that {@code key} tells of;
   * null while there is nothing.
   */
  DirectEntry direct(ScriptFunction function, int number, long key, Registers registers) {
    DirectEntry entry = function.direct(key, registers);
    if (entry == null && number < tables.functions().size()) {
      entry = makeDirect(function, number, key, registers);
    }
    return entry == null || entry.code() == null ? null : entry;
  }

  /** Has code made, once, for arguments that a translated function is called with. */
  private DirectEntry makeDirect(
      ScriptFunction function, int number, long key, Registers registers) {
    SortedSet<Integer> named = GlobalTags.named(tables, List.of(number));
    GlobalTags globals =
        GlobalTags.in(registers, named.stream().mapToInt(Integer::intValue).toArray());
    // whether it becomes code or not, it is not tried again
    if (!function.triesDirect(key, globals)) {
      function.wasNotDirect(1);
      return null;
    }
    if (when == Translation.ALWAYS) {
      translateDirect(function, number, key, globals);
    } else {
      Thread.ofVirtual()
          .name("translate " + function.name())
          .start(() -> translateDirect(function, number, key, globals));
    }
    return function.direct(key, registers);
  }

  private void translateDirect(ScriptFunction function, int number, long key, GlobalTags globals) {
    try {
      if (!DirectUnit.translate(tables, number, key, globals)) {
        function.wasNotDirect(CALLS_WITHOUT_CODE);
      }
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      function.wasNotDirect(CALLS_WITHOUT_CODE);
      fault.set(e);
    }
  }

  /** Turns between two looks for code of the loop. */
  int turnsUntilLoop() {
    return when == Translation.ALWAYS ? 1 : TURNS_UNTIL_LOOP;
  }

  /**
   * What goes on directly with the loop of {@code function} that begins a turn at {@code pc}; null
   * while there is nothing.
   */
  LoopEntry loop(ScriptFunction function, int pc, Registers registers, int base) {
    LoopEntry entry = function.loop(pc, registers, base);
    if (entry == null) {
      LoopRegion region = new LoopRegion(function, tables, pc);
      entry = function.triesLoop(region, region.tags(registers, base));
      if (entry != null) {
        makeLoop(entry);
      }
    }
    return entry == null || !entry.ready() ? null : entry;
  }

  private void makeLoop(LoopEntry entry) {
    if (when == Translation.ALWAYS) {
      translateLoop(entry);
    } else {
      Thread.ofVirtual()
          .name("translate a loop of " + entry.region().function().name())
          .start(() -> translateLoop(entry));
    }
  }

  private void translateLoop(LoopEntry entry) {
    try {
      DirectUnit.translate(tables, entry);
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      fault.set(e);
    }
  }

  /** A fault that a translation ended with since the last call of this. */
  Optional<Throwable> takeFault() {
    // looked at in every frame: reading alone is cheap
    return fault.get() == null ? Optional.empty() : Optional.of(fault.getAndSet(null));
  }

  private void translate(ScriptFunction function) {
    if (function.untranslatable) {
      return;
    }
    try {
      Optional<TranslatedCode> code = translator.translate(function, tables);
      function.untranslatable = code.isEmpty();
      code.ifPresent(function::install);
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      function.untranslatable = true;
      fault.set(e);
    }
  }
}
