package org.pendant.editors.dap.run;

import static org.pendant.editors.dap.run.DebuggedRunTexts.text;

import java.util.List;
import org.pendant.text.Language;

/**
 * Debug targets: makes of the options of a command line what is debugged. What reads files and
 * knows options is not known here.
 */
@FunctionalInterface
public interface DebugTargets {
  /**
   * Reads a program and what it runs on; may take long.
   *
   * @param program file of a script or a tree
   * @param options as {@code pendant run} has them, such as {@code --robot}, {@code ur5e}
   * @param language in which it is told what is wrong
   * @throws TargetRefusal if a file cannot be read or an option makes no sense
   */
  DebugTarget target(String program, List<String> options, Language language) throws TargetRefusal;

  /**
   * Reads a test and prepares it; may take long.
   *
   * @param file of tests
   * @param test its name, with the case behind it if it has several
   * @param options as {@code pendant test} has them
   * @param language in which it is told what is wrong
   * @throws TargetRefusal if it cannot be debugged, or there is none, or an option makes no sense
   */
  default DebugTarget test(String file, String test, List<String> options, Language language)
      throws TargetRefusal {
    throw new TargetRefusal(text("noTestsHere"));
  }
}
