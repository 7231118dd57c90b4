package org.pendant.controller.program.script;

import org.pendant.controller.installation.Installation;
import org.pendant.controller.program.PlayFrom;
import org.pendant.controller.program.ProgramTree;

/** Makes the script that a program tree runs as. Pure; any thread may call it. */
public final class ScriptGenerator {
  private ScriptGenerator() {}

  /**
   * The script of a tree; docs/program-trees.md says what each node becomes. What is unfinished
   * generates nothing or a comment, so a tree that is not checked gives a script that may do less
   * than it seems.
   *
   * @param programName what the program is called; need not be a name of the language
   * @param installation what is set up at the start, and what the nodes' names mean
   */
  public static GeneratedScript generate(
      String programName, ProgramTree tree, Installation installation) {
    ScriptContext context = new ScriptContext(programName, tree, installation);
    new ProgramWriter(context).write();
    return context.lines().script();
  }

  /**
   * The script of a tree whose first turn begins at a node, see {@link PlayFrom}. Names, and the
   * numbers in labels and places, are those of the whole tree; a node that is in the first turn and
   * in the others has several places.
   *
   * @throws IllegalArgumentException if {@link PlayFrom#whyNot} has a reason
   */
  public static GeneratedScript generateFrom(
      String programName, ProgramTree tree, long key, Installation installation) {
    ScriptContext context =
        new ScriptContext(programName, PlayFrom.from(tree, key), tree, installation);
    new ProgramWriter(context).write();
    return context.lines().script();
  }
}
