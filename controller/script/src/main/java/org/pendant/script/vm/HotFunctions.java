package org.pendant.script.vm;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Hot functions: finds the functions of one run that are worth a translation, and has them
 * translated without delaying the frame. A function that cannot be translated is interpreted.
 */
final class HotFunctions {
  /** Calls and turns after which a function is translated: a fraction of a millisecond's work. */
  private static final int HOT = 5000;

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
