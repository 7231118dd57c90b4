package org.pendant.controller.machine;

import java.util.Optional;

/**
 * Finds the functions of one run that are worth a translation, and has them translated without
 * holding up the frame.
 */
final class HotFunctions {
  /** Calls and turns after which a function is translated: a fraction of a millisecond's work. */
  private static final int HOT = 5000;

  private final Translation when;
  private final Program.Tables tables;

  HotFunctions(Translation when, Program.Tables tables) {
    this.when = when;
    this.tables = tables;
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

  private void translate(ScriptFunction function) {
    if (!function.untranslatable) {
      Optional<TranslatedCode> code = Translator.translate(function, tables);
      function.untranslatable = code.isEmpty();
      code.ifPresent(function::install);
    }
  }
}
