package org.pendant.controller.bench;

import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.Program;

/** Tested programs: finds the programs that a test starts. */
@FunctionalInterface
public interface TestedPrograms {
  /**
   * Reads and compiles a program.
   *
   * @param file its name as the test writes it; bytes, one {@code char} a byte
   * @throws ScriptError if there is none, or it does not compile
   */
  Program load(String file) throws ScriptError;
}
