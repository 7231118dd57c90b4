package org.pendant.protocols.teachpendant;

import java.util.Optional;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.script.vm.Program;

/**
 * Driven program: a program for one run, with what a driver has sent.
 *
 * @param program compiled
 * @param tree with what was sent
 * @param script of the tree
 */
record DrivenProgram(Program program, TreeFile tree, GeneratedScript script) {

  /** Which line of what was sent a line of a text is, in words. */
  Optional<String> receivedAt(String source, int line) {
    return source.equals(program.source().name())
        ? tree.receivedAt(script, line)
        : Optional.empty();
  }
}
