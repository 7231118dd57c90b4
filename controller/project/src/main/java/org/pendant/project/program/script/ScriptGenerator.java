package org.pendant.project.program.script;

import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.PlayFrom;
import org.pendant.project.program.ProgramTree;

/** Script generator: makes the script that a program tree runs as. Pure; any thread may call it. */
public final class ScriptGenerator {
  private ScriptGenerator() {}

  /** As the other of that name, without what drivers send. */
  public static GeneratedScript generate(
      String programName, ProgramTree tree, Installation installation) {
    return generate(programName, tree, installation, Optional.empty());
  }

  /**
   * The script of a tree; docs/program-trees.md says what each node becomes. What is unfinished
   * generates nothing or a comment, so a tree that is not checked gives a script that may do less
   * than it seems.
   *
   * @param programName what the program is called; need not be a name of the language
   * @param installation what is set up at the start, and what the nodes' names mean
   * @param control what External Control nodes do; empty for nothing
   */
  public static GeneratedScript generate(
      String programName,
      ProgramTree tree,
      Installation installation,
      Optional<ControlScript> control) {
    return written(new ScriptContext(programName, tree, tree, installation, control));
  }

  /** As the other of that name, without what drivers send. */
  public static GeneratedScript generateFrom(
      String programName, ProgramTree tree, long key, Installation installation) {
    return generateFrom(programName, tree, key, installation, Optional.empty());
  }

  /**
   * The script of a tree whose first turn begins at a node, see {@link PlayFrom}. Names, and the
   * numbers in labels and places, are those of the whole tree; a node that is in the first turn and
   * in the others has several places.
   *
   * @param control what External Control nodes do; empty for nothing
   * @throws IllegalArgumentException if {@link PlayFrom#whyNot} has a reason
   */
  public static GeneratedScript generateFrom(
      String programName,
      ProgramTree tree,
      long key,
      Installation installation,
      Optional<ControlScript> control) {
    return written(
        new ScriptContext(programName, PlayFrom.from(tree, key), tree, installation, control));
  }

  private static GeneratedScript written(ScriptContext context) {
    new ScriptProgramWriter(context).write();
    return context.lines().script(new GeneratedNames(context.program(), context.names().made()));
  }
}
